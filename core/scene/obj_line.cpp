#include "scene/obj_line.h"

#include <algorithm>

#include <fmt/format.h>

#include "scene/obj_check.h"

namespace ps {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\f' || c == '\v'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Joins lines that end in a backslash. The line ends taken out are put back after the joined line.
std::string join_lines(const std::string& text) {
  std::string joined;
  joined.reserve(text.size());
  std::string owed;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const bool ends_line = i + 1 < text.size() && (text[i + 1] == '\n' || text[i + 1] == '\r');
    if (c == '\\' && ends_line) {
      const bool pair = i + 2 < text.size() && text[i + 1] == '\r' && text[i + 2] == '\n';
      i += pair ? 2 : 1;
      joined += ' ';
      owed += '\n';
      continue;
    }
    joined += c;
    const bool first_of_pair = c == '\r' && i + 1 < text.size() && text[i + 1] == '\n';
    if ((c == '\n' || c == '\r') && !first_of_pair && !owed.empty()) {
      joined += owed;
      owed.clear();
    }
  }
  return joined;
}

/// What is wrong with a number, or nullptr. Digits alone decide, so that no value has to be computed.
const char* number_fault(std::string_view word) {
  constexpr const char* not_a_number = "a number";
  std::size_t i = 0;
  if (i < word.size() && (word[i] == '+' || word[i] == '-')) ++i;
  long leading = 0;  // decimal exponent of the first digit other than 0
  bool seen = false, digits = false;
  for (; i < word.size() && is_digit(word[i]); ++i) {
    digits = true;
    if (seen) ++leading;
    if (word[i] != '0') seen = true;
  }
  if (i < word.size() && word[i] == '.') {
    long place = -1;
    for (++i; i < word.size() && is_digit(word[i]); ++i, --place) {
      digits = true;
      if (!seen && word[i] != '0') {
        seen = true;
        leading = place;
      }
    }
  }
  if (!digits) return not_a_number;
  long exponent = 0;
  if (i < word.size() && (word[i] == 'e' || word[i] == 'E')) {
    ++i;
    const bool negative = i < word.size() && word[i] == '-';
    if (i < word.size() && (word[i] == '+' || word[i] == '-')) ++i;
    const std::size_t first = i;
    for (; i < word.size() && is_digit(word[i]); ++i) exponent = std::min(exponent * 10 + (word[i] - '0'), 100000L);
    if (i == first) return not_a_number;
    if (negative) exponent = -exponent;
  }
  if (i != word.size()) return not_a_number;
  if (leading + exponent >= 12 || exponent > 300) return "a number below 1e12";
  if (leading + exponent < -300 || exponent < -300) return "a number that is 0 or above 1e-300";
  return nullptr;
}

}  // namespace

ObjLine::ObjLine(std::string& text, std::size_t begin, std::size_t end, int number, const std::string& file)
    : text_(&text), begin_(begin), end_(end), at_(begin), word_begin_(begin), word_end_(begin), number_(number),
      file_(&file) {
  const auto comment = std::string_view(text).substr(begin, end - begin).find('#');
  if (comment == std::string_view::npos) return;
  // A # inside a word belongs to a name.
  if (comment > 0 && !is_blank(text[begin + comment - 1])) return;
  std::fill(text.begin() + static_cast<std::ptrdiff_t>(begin + comment),
            text.begin() + static_cast<std::ptrdiff_t>(end), ' ');
}

std::string_view ObjLine::next() {
  const std::string& text = *text_;
  while (at_ < end_ && is_blank(text[at_])) ++at_;
  word_begin_ = at_;
  while (at_ < end_ && !is_blank(text[at_])) ++at_;
  word_end_ = at_;
  return word();
}

std::string_view ObjLine::rest() {
  const std::string& text = *text_;
  while (at_ < end_ && is_blank(text[at_])) ++at_;
  std::size_t last = end_;
  while (last > at_ && is_blank(text[last - 1])) --last;
  word_begin_ = at_;
  word_end_ = last;
  at_ = end_;
  return word();
}

void ObjLine::blank_word_end(std::size_t count) {
  std::fill_n(text_->begin() + static_cast<std::ptrdiff_t>(word_end_ - count), count, ' ');
  word_end_ -= count;
}

void ObjLine::fail(const std::string& found, const std::string& expected) const {
  throw InputError({*file_, number_, static_cast<int>(word_begin_ - begin_) + 1}, found, expected);
}

std::string ObjLine::shown() const {
  if (word_begin_ == word_end_) return "the end of the line";
  return fmt::format("'{}'", word().substr(0, 60));
}

void ObjLine::require_number() {
  if (const char* expected = number_fault(next())) fail(shown(), expected);
}

void prepare_obj_text(std::string& text, const std::string& file) {
  const std::string_view view = text;
  if (view.substr(0, 2) == "\xFF\xFE" || view.substr(0, 2) == "\xFE\xFF")
    throw InputError({file, 1, 1}, "UTF-16 text", "UTF-8 text");
  if (view.substr(0, 3) == "\xEF\xBB\xBF") std::fill_n(text.begin(), 3, ' ');
  const auto nul = view.find('\0');
  if (nul != std::string_view::npos) {
    const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(nul), '\n');
    throw InputError({file, static_cast<int>(line), 0}, "a NUL byte", "text");
  }
  // Other programs take these for blanks as we do, tinyobjloader does not.
  for (const char blank : {'\f', '\v'})
    if (view.find(blank) != std::string_view::npos) std::replace(text.begin(), text.end(), blank, ' ');
  if (view.find("\\\n") != std::string_view::npos || view.find("\\\r") != std::string_view::npos)
    text = join_lines(text);
}

void require_obj_line_length(std::size_t length, int number, const std::string& file) {
  if (length > max_obj_line)
    throw InputError({file, number, 1}, fmt::format("a line of {} bytes", length),
                     fmt::format("at most {} bytes", max_obj_line));
}

}  // namespace ps
