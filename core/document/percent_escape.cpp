#include <fmt/format.h>

#include "base/check.h"
#include "base/number_text.h"
#include "document/permalink.h"

namespace ps {
namespace {

/// Letters and digits of ASCII, and what neither a URL's query nor a shell gives a meaning.
bool stays(char c) {
  if ((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9')) return true;
  return std::string_view("-_./,:+@").find(c) != std::string_view::npos;
}

}  // namespace

std::string percent_escape(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    if (stays(c))
      escaped += c;
    else
      escaped += fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return escaped;
}

std::string percent_unescape(std::string_view text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      plain += text[i];
      continue;
    }
    const std::string_view digits = text.substr(i + 1, 2);
    const auto value = parse_integer<unsigned>(digits, 16);
    if (digits.size() != 2 || !value)
      throw InputError(fmt::format("permalink: found '%{}', expected two hexadecimal digits after %", digits));
    plain += static_cast<char>(*value);
    i += 2;
  }
  return plain;
}

}  // namespace ps
