#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace ps {

/// Reads the whole of `text` as a decimal number ("-1.5", "2e-3"), whatever the user's locale. Nothing for anything
/// else: empty text, spaces, trailing characters, "inf", "nan", hexadecimal, or a value that overflows double.
/// (std::from_chars for double does not exist in libc++ 14.)
std::optional<double> parse_number(std::string_view text);

/// The digits of a whole number with their thousands apart: "57,600".
std::string with_thousands(std::string digits);

/// As parse_number, for what a person types: a comma may set thousands apart ("57,600", "1,234.5"). A comma anywhere
/// else ("1,5", "1,0000") is no number.
std::optional<double> parse_typed_number(std::string_view text);

}  // namespace ps
