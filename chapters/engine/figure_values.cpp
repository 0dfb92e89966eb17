#include "engine/figure_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/number_text.h"
#include "base/spelling.h"
#include "engine/words.h"

namespace ps {
namespace {

constexpr double farthest_place = 1e6;

/// The parts between commas, each with its place.
std::vector<FigureWord> parts_of(const FigureWord& word) {
  std::vector<FigureWord> parts;
  for (std::size_t at = 0; at <= word.text.size();) {
    const std::size_t end = std::min(word.text.find(',', at), word.text.size());
    const std::string_view part = std::string_view(word.text).substr(at, end - at);
    const std::size_t blanks = std::min(part.find_first_not_of(' '), part.size());
    SourcePlace place = word.place;
    place.column += static_cast<int>(at + blanks);
    parts.push_back({std::string(without_blanks(part)), place});
    at = end + 1;
  }
  return parts;
}

FigureWord behind(const FigureWord& word, std::size_t bytes) {
  FigureWord rest{word.text.substr(bytes), word.place};
  rest.place.column += static_cast<int>(bytes);
  return rest;
}

std::string_view one_of(const FigureWord& word, const std::vector<std::string_view>& known) {
  const auto found = std::find(known.begin(), known.end(), word.text);
  if (found == known.end())
    throw InputError(word.place, fmt::format("'{}'", shown_start(word.text)), expected_word(word.text, known));
  return *found;
}

}  // namespace

std::vector<FigureWord> words_of_line(std::string_view line, const SourcePlace& start) {
  std::vector<FigureWord> words;
  int open = 0;
  bool in_word = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (open == 0 && (c == ' ' || c == '\t' || c == '\r')) {
      in_word = false;
      continue;
    }
    if (!in_word) words.push_back({{}, {start.file, start.line, start.column + static_cast<int>(i)}});
    in_word = true;
    words.back().text += c;
    if (c == '(') ++open;
    if (c == ')') open = std::max(open - 1, 0);
  }
  if (open > 0) throw InputError(words.back().place, "'(' without its partner", "(x, y)");
  return words;
}

double number_of(const FigureWord& word) {
  const auto number = parse_number(word.text);
  if (!number || !(std::abs(*number) <= farthest_place))
    throw InputError(word.place, fmt::format("'{}'", shown_start(word.text)), "a number");
  return *number;
}

Vec2d pair_of(const FigureWord& word) {
  if (word.text.size() >= 2 && word.text.front() == '(' && word.text.back() == ')') {
    FigureWord inside = behind(word, 1);
    inside.text.pop_back();
    if (const auto parts = parts_of(inside); parts.size() == 2) return {number_of(parts[0]), number_of(parts[1])};
  }
  throw InputError(word.place, fmt::format("'{}'", shown_start(word.text)), "(x, y)");
}

FigureValues::FigureValues(std::vector<FigureWord> words) {
  for (FigureWord& word : words) {
    const std::size_t sign = word.text.find('=');
    if (sign == std::string::npos || sign == 0)
      throw InputError(word.place, fmt::format("'{}'", shown_start(word.text)), "KEY=VALUE");
    values_.push_back({{word.text.substr(0, sign), word.place}, behind(word, sign + 1)});
  }
}

const FigureWord* FigureValues::find(std::string_view key) {
  asked_.push_back(key);
  for (Value& value : values_)
    if (value.key.text == key) {
      value.used = true;
      return &value.value;
    }
  return nullptr;
}

double FigureValues::number(std::string_view key, double otherwise, FigureRange range) {
  const std::vector<double> read = numbers(key, {otherwise}, range);
  if (read.size() != 1) refuse(key, "one number");
  return read.front();
}

std::vector<double> FigureValues::numbers(std::string_view key, std::vector<double> otherwise, FigureRange range) {
  const FigureWord* value = find(key);
  if (!value) return otherwise;
  std::vector<double> read;
  for (const FigureWord& part : parts_of(*value)) {
    read.push_back(number_of(part));
    if (!(read.back() >= range.low && read.back() <= range.high))
      throw InputError(part.place, fmt::format("'{}'", shown_start(part.text)),
                       fmt::format("a number from {:g} to {:g}", range.low, range.high));
  }
  return read;
}

std::pair<std::string, std::string> FigureValues::names(std::string_view key,
                                                        const std::pair<std::string, std::string>& otherwise) {
  const FigureWord* value = find(key);
  if (!value) return otherwise;
  const std::vector<FigureWord> parts = parts_of(*value);
  if (parts.size() != 2) refuse(key, "two words with a comma between them");
  return {parts[0].text, parts[1].text};
}

std::vector<Vec2d> FigureValues::pairs(std::string_view key, std::vector<Vec2d> otherwise) {
  const FigureWord* value = find(key);
  if (!value) return otherwise;
  std::vector<Vec2d> read;
  for (std::size_t at = 0; at < value->text.size();) {
    const std::size_t end = std::min(value->text.find(')', at), value->text.size() - 1);
    FigureWord pair = behind(*value, at);
    pair.text.resize(end + 1 - at);
    read.push_back(pair_of(pair));
    at = end + 1;
  }
  return read;
}

std::string_view FigureValues::word(std::string_view key, const std::vector<std::string_view>& known) {
  const FigureWord* value = find(key);
  return value ? one_of(*value, known) : known.front();
}

std::vector<std::string_view> FigureValues::words(std::string_view key, const std::vector<std::string_view>& known) {
  const FigureWord* value = find(key);
  if (!value) return known;
  std::vector<std::string_view> read;
  for (const FigureWord& part : parts_of(*value)) read.push_back(one_of(part, known));
  return read;
}

void FigureValues::refuse(std::string_view key, const std::string& expected) const {
  const auto at = std::find_if(values_.begin(), values_.end(), [&](const Value& each) { return each.key.text == key; });
  PS_ASSERT(!values_.empty(), "defaults that are refused");
  const FigureWord& value = at == values_.end() ? values_.back().value : at->value;
  throw InputError(value.place, fmt::format("'{}'", shown_start(value.text)), expected);
}

void FigureValues::require_all_used() const {
  for (const Value& value : values_)
    if (!value.used)
      throw InputError(value.key.place, fmt::format("'{}'", shown_start(value.key.text)),
                       expected_word(value.key.text, asked_));
}

}  // namespace ps
