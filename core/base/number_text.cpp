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

}  // namespace ps
