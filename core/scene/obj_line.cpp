#include "scene/obj_line.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "base/number_text.h"

namespace ps {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\f' || c == '\v'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Where the line's comment begins, or its length. `in_names`: the text is what follows a statement's word.
std::size_t comment_begin(std::string_view text, bool in_names) {
  if (!in_names) return std::min(text.find('#'), text.size());
  for (std::size_t i = text.find('#'); i != std::string_view::npos; i = text.find('#', i + 1)) {
    const bool apart = (i == 0 || is_blank(text[i - 1])) && (i + 1 == text.size() || is_blank(text[i + 1]));
    if (apart) return i;
  }
  return text.size();
}

/// Whether a line has a comment, which takes its end with it. A # glued to a word is one in a statement of numbers
/// alone.
bool has_comment(std::string_view text) {
  static const std::string no_file;
  const std::string_view word = ObjLine(text, 0, no_file).next();
  constexpr std::array<std::string_view, 8> of_numbers{"v", "vt", "vn", "f", "fo", "l", "p", "s"};
  const bool glued = std::find(of_numbers.begin(), of_numbers.end(), word) != of_numbers.end();
  for (std::size_t i = text.find('#'); i != std::string_view::npos; i = text.find('#', i + 1))
    if (glued || i == 0 || is_blank(text[i - 1])) return true;
  return false;
}

/// The digits of a number as a whole number times a power of ten.
struct Decimal {
  std::uint64_t digits = 0;
  long exponent = 0;    ///< of the last of them
  int significant = 0;  ///< digits from the first that is not 0

  static constexpr int most = 19;  ///< fit into 64 bits
  void add(char c, bool behind_point) {
    if (c != '0' || significant > 0) ++significant;
    if (significant <= most) digits = digits * 10 + static_cast<std::uint64_t>(c - '0');
    if (behind_point && significant <= most) --exponent;
    if (!behind_point && significant > most) ++exponent;
  }
  /// Decimal exponent of the first digit that is not 0; 0 for 0.
  long leading() const { return significant == 0 ? 0 : exponent + std::min(significant, most) - 1; }
  /// The value where one exact product or quotient gives it (Clinger 1990).
  std::optional<double> exact(long more) const {
    constexpr std::array<double, 23> powers{1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                            1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
    const long power = exponent + more;
    constexpr long last = powers.size() - 1;
    if (significant > most || digits > (std::uint64_t{1} << 53) || power < -last || power > last) return {};
    const auto whole = static_cast<double>(digits);
    return power < 0 ? whole / powers[static_cast<std::size_t>(-power)]
                     : whole * powers[static_cast<std::size_t>(power)];
  }
};

}  // namespace

ObjNumber read_obj_number(std::string_view word) {
  constexpr ObjNumber not_a_number{0, "a number"};
  std::size_t i = 0;
  const bool is_negative = !word.empty() && word[0] == '-';
  if (!word.empty() && (word[0] == '+' || word[0] == '-')) ++i;
  Decimal decimal;
  const std::size_t first = i;
  for (; i < word.size() && is_digit(word[i]); ++i) decimal.add(word[i], false);
  bool digits = i > first;
  if (i < word.size() && word[i] == '.')
    for (++i; i < word.size() && is_digit(word[i]); ++i, digits = true) decimal.add(word[i], true);
  if (!digits) return not_a_number;
  long exponent = 0;
  if (i < word.size() && (word[i] == 'e' || word[i] == 'E')) {
    ++i;
    const bool below = i < word.size() && word[i] == '-';
    if (i < word.size() && (word[i] == '+' || word[i] == '-')) ++i;
    const std::size_t begin = i;
    for (; i < word.size() && is_digit(word[i]); ++i) exponent = std::min(exponent * 10 + (word[i] - '0'), 100000L);
    if (i == begin) return not_a_number;
    if (below) exponent = -exponent;
  }
  if (i != word.size()) return not_a_number;
  const long leading = decimal.leading() + exponent;
  if (leading >= 12 || exponent > 300) return {0, "a number below 1e12"};
  if (leading < -300 || exponent < -300) return {0, "a number that is 0 or above 1e-300"};
  if (const auto value = decimal.exact(exponent)) return {is_negative ? -*value : *value};
  return {parse_number(word).value_or(0)};
}

std::string_view ObjLine::next() {
  // Old programs print "1.#IND" and "1.#QNAN" for what is not a number.
  const auto ends_word = [&](std::size_t i) {
    return is_blank(text_[i]) || (text_[i] == '#' && !in_names_ && (i == 0 || text_[i - 1] != '.'));
  };
  while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
  word_begin_ = at_;
  while (at_ < text_.size() && !ends_word(at_)) ++at_;
  word_end_ = at_;
  return word();
}

void ObjLine::begin_names() {
  if (in_names_) return;
  in_names_ = true;
  text_ = text_.substr(0, at_ + comment_begin(text_.substr(at_), true));
}

std::string_view ObjLine::rest() {
  std::size_t last = in_names_ ? text_.size() : at_ + comment_begin(text_.substr(at_), false);
  while (at_ < last && is_blank(text_[at_])) ++at_;
  while (last > at_ && is_blank(text_[last - 1])) --last;
  word_begin_ = at_;
  word_end_ = last;
  at_ = text_.size();
  return word();
}

std::string_view ObjLine::name() {
  begin_names();
  return rest();
}

InputError ObjLine::error(const std::string& found, const std::string& expected) const {
  return {{*file_, number_, static_cast<int>(word_begin_) + 1}, found, expected};
}

std::string ObjLine::shown() const {
  if (word_begin_ == word_end_) return "the end of the line";
  return fmt::format("'{}'", word().substr(0, 60));
}

double ObjLine::require_number() {
  const ObjNumber number = read_obj_number(next());
  if (number.fault != nullptr) fail(shown(), number.fault);
  return number.value;
}

ObjLines::ObjLines(std::string_view text, const std::string& file, std::size_t most_bytes)
    : text_(text), file_(file), most_bytes_(most_bytes) {
  if (text.substr(0, 2) == "\xFF\xFE" || text.substr(0, 2) == "\xFE\xFF")
    throw InputError({file, 1, 1}, "UTF-16 text", "UTF-8 text");
  if (text.substr(0, 3) == "\xEF\xBB\xBF") at_ = 3;
  const auto nul = text.find('\0');
  if (nul == std::string_view::npos) return;
  const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(nul), '\n');
  throw InputError({file, static_cast<int>(line), 0}, "a NUL byte", "text");
}

/// The next line as it stands in the file.
std::string_view ObjLines::take() {
  const std::size_t begin = at_;
  while (at_ < text_.size() && text_[at_] != '\n' && text_[at_] != '\r') ++at_;
  const std::string_view line = text_.substr(begin, at_ - begin);
  ++at_;
  if (at_ < text_.size() && text_[at_ - 1] == '\r' && text_[at_] == '\n') ++at_;
  ++count_;
  return line;
}

std::optional<ObjLine> ObjLines::next() {
  if (at_ >= text_.size()) return {};
  std::string_view line = take();
  const int number = count_;
  if (!line.empty() && line.back() == '\\' && !has_comment(line)) {
    joined_ = line;
    bool goes_on = true;
    while (goes_on && joined_.size() <= most_bytes_) {
      joined_.back() = ' ';
      line = at_ < text_.size() ? take() : std::string_view();
      joined_ += line;
      goes_on = !line.empty() && line.back() == '\\' && !(line.find('#') != line.npos && has_comment(joined_));
    }
    line = joined_;
  }
  if (line.size() > most_bytes_)
    throw InputError({file_, number, 1}, fmt::format("a line of {} bytes", line.size()),
                     fmt::format("at most {} bytes", most_bytes_));
  return ObjLine(line, number, file_);
}

std::vector<std::string> meant_names(std::string_view name) {
  std::vector<std::string> names;
  for (const std::string_view form : {name, name.substr(0, name.find(" #")), name.substr(0, name.find("\t#"))}) {
    const auto last = form.find_last_not_of(" \t\f\v");
    if (last == std::string_view::npos) continue;
    const std::string_view trimmed = form.substr(0, last + 1);
    names.emplace_back(trimmed);
    if (trimmed.size() > 2 && trimmed.front() == '"' && trimmed.back() == '"')
      names.emplace_back(trimmed.substr(1, trimmed.size() - 2));
  }
  return names;
}

}  // namespace ps
