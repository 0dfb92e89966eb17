#include "base/number_text.h"

#include <cmath>
#include <locale>
#include <sstream>
#include <string>

namespace ps {

std::optional<double> parse_number(std::string_view text) {
  constexpr std::string_view decimal_characters = "+-.0123456789eE";
  if (text.empty() || text.find_first_not_of(decimal_characters) != std::string_view::npos) return {};
  std::istringstream stream{std::string(text)};
  stream.imbue(std::locale::classic());
  double value = 0;
  stream >> std::noskipws >> value;
  if (stream.fail() || stream.peek() != std::istringstream::traits_type::eof() || !std::isfinite(value)) return {};
  return value;
}

std::string with_thousands(std::string digits) {
  for (std::size_t left = digits.size(); left > 3;) digits.insert(left -= 3, 1, ',');
  return digits;
}

std::optional<double> parse_typed_number(std::string_view text) {
  const std::size_t sign = text.find_first_of("+-") == 0 ? 1 : 0;
  const std::string_view whole = text.substr(sign, text.find_first_not_of("0123456789,", sign) - sign);
  std::string digits(whole);
  std::erase(digits, ',');
  if (digits.size() < whole.size() && with_thousands(digits) != whole) return {};
  return parse_number(std::string(text.substr(0, sign)) + digits + std::string(text.substr(sign + whole.size())));
}

}  // namespace ps
