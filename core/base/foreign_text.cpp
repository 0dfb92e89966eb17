#include "base/foreign_text.h"

#include <cstdint>

namespace ps {
namespace {

struct Character {
  std::uint32_t code = 0;
  std::size_t bytes = 0;  ///< 0 if the text does not begin with a character in UTF-8
};

/// The first character of a text that is not empty. Overlong forms, surrogates and codes above U+10FFFF are none.
Character first_character(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
  const std::uint8_t lead = byte(0);
  if (lead < 0x80) return {lead, 1};
  const std::size_t bytes = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || text.size() < bytes) return {};
  std::uint32_t code = lead & (0x7Fu >> bytes);
  for (std::size_t i = 1; i < bytes; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return {};
    code = code << 6 | (byte(i) & 0x3Fu);
  }
  constexpr std::uint32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
  if (code < least[bytes] || code > 0x10FFFF || (code >= 0xD800 && code < 0xE000)) return {};
  return {code, bytes};
}

bool is_readable(std::uint32_t code) {
  if (code < ' ') return code == '\n' || code == '\t';
  if (code >= 0x7F && code < 0xA0) return false;
  const bool turns_writing = code == 0x061C || code == 0x200E || code == 0x200F || (code >= 0x202A && code <= 0x202E) ||
                             (code >= 0x2066 && code <= 0x2069);
  return !turns_writing;
}

}  // namespace

std::string foreign_text(std::string_view text) {
  std::string readable;
  readable.reserve(text.size());
  while (!text.empty()) {
    const Character first = first_character(text);
    if (first.bytes > 0 && is_readable(first.code))
      readable += text.substr(0, first.bytes);
    else
      readable += '?';
    text.remove_prefix(first.bytes > 0 ? first.bytes : 1);
  }
  return readable;
}

std::size_t bytes_of_utf8(std::string_view text) {
  std::size_t at = 0;
  while (at < text.size()) {
    const Character next = first_character(text.substr(at));
    if (next.bytes == 0) return at;
    at += next.bytes;
  }
  return at;
}

}  // namespace ps
