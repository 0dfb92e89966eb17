#include "image/pnm_text.h"

#include <fmt/format.h>

#include "base/check.h"
#include "base/number_text.h"

namespace ps {
namespace {

bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

/// A word as a message may show it: short and printable.
std::string shown(std::string_view word) {
  constexpr std::size_t longest = 24;
  std::string text;
  for (const char c : word.substr(0, longest)) text += c > 32 && c < 127 ? c : '?';
  return "'" + text + (word.size() > longest ? "...'" : "'");
}

}  // namespace

void PnmText::fail(const std::string& found, const std::string& expected) const {
  throw InputError({file_, line_, 0}, found, expected);
}

void PnmText::skip_space() {
  while (at_ < bytes_.size()) {
    if (bytes_[at_] == '#') {
      while (at_ < bytes_.size() && bytes_[at_] != '\n' && bytes_[at_] != '\r') ++at_;
    } else if (is_space(bytes_[at_])) {
      if (bytes_[at_] == '\n') ++line_;
      ++at_;
    } else {
      return;
    }
  }
}

std::string_view PnmText::word(std::string_view expected) {
  skip_space();
  if (at_ == bytes_.size()) fail("the end of the file", std::string(expected));
  const std::size_t begin = at_;
  while (at_ < bytes_.size() && !is_space(bytes_[at_]) && bytes_[at_] != '#') ++at_;
  return bytes_.substr(begin, at_ - begin);
}

std::int64_t PnmText::integer(std::int64_t low, std::int64_t high, std::string_view what) {
  const std::string expected = fmt::format("{}: a whole number from {} to {}", what, low, high);
  const std::string_view text = word(expected);
  const auto value = parse_integer<std::int64_t>(text);
  if (!value || *value < low || *value > high) fail(shown(text), expected);
  return *value;
}

double PnmText::real(std::string_view what) {
  const std::string expected = fmt::format("{}: a number", what);
  const std::string_view text = word(expected);
  const auto value = parse_number(text);
  if (!value) fail(shown(text), expected);
  return *value;
}

std::string_view PnmText::rest() {
  if (at_ == bytes_.size()) fail("the end of the file", "a white-space character and the pixels");
  return bytes_.substr(at_ + 1);
}

}  // namespace ps
