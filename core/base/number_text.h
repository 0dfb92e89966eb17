#pragma once
#include <charconv>
#include <concepts>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace ps {

/// Reads the whole of `text` as a decimal number ("-1.5", "2e-3"), whatever the user's locale. nullopt for anything
/// else: empty text, spaces, trailing characters, "inf", "nan", hexadecimal, or a value that overflows double.
/// (std::from_chars for double does not exist in libc++ 14.)
std::optional<double> parse_number(std::string_view text);

/// Takes a whole number in digits of `base` ("-12"; no minus where Integer has no sign) off the front of `text`, which
/// keeps what follows it. nullopt, and `text` as it was, if it begins otherwise or the value does not fit into Integer.
template <std::integral Integer>
std::optional<Integer> take_integer(std::string_view& text, int base = 10) {
  Integer value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
  if (error != std::errc()) return {};
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return value;
}

/// The same for the whole of `text`. nullopt for anything else: empty text, spaces, a plus, or trailing characters.
template <std::integral Integer>
std::optional<Integer> parse_integer(std::string_view text, int base = 10) {
  const auto value = take_integer<Integer>(text, base);
  return text.empty() ? value : std::nullopt;
}

/// The digits of a whole number with their thousands apart: "57,600".
std::string with_thousands(std::string digits);

/// As parse_number, for what a person types: a comma may set thousands apart ("57,600", "1,234.5"). A comma anywhere
/// else ("1,5", "1,0000") gives nullopt.
std::optional<double> parse_typed_number(std::string_view text);

}  // namespace ps
