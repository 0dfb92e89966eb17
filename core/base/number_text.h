#pragma once
#include <optional>
#include <string_view>

namespace ps {

/// Reads the whole of `text` as a decimal number ("-1.5", "2e-3"), whatever the user's locale. Nothing for anything
/// else: empty text, spaces, trailing characters, "inf", "nan", hexadecimal, or a value that overflows double.
/// (std::from_chars for double does not exist in libc++ 14.)
std::optional<double> parse_number(std::string_view text);

}  // namespace ps
