#include "engine/figure_number.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "base/number_text.h"
#include "base/spelling.h"
#include "engine/figure_values.h"
#include "engine/words.h"
#include "math/portable.h"

namespace ps {
namespace {

constexpr std::string_view notation = "pixel NAME EVENT: NUMBER = N, with N at the step's own pixel";
constexpr std::string_view of_a_name = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789";
constexpr double least_shown = 1e-4;

std::string rounded_number(double value) {
  if (std::abs(value) < least_shown) return "0";
  return std::abs(value) < 1000 ? fmt::format("{:.3g}", value) : fmt::format("{:.0f}", value);
}

}  // namespace

FigureNumber read_figure_number(std::string_view line, const SourcePlace& start) {
  const std::size_t sign = line.rfind(" = ");
  const std::vector<FigureWord> words = words_of_line(line.substr(0, sign), start);
  if (words.size() < 3 || sign == std::string_view::npos)
    throw InputError(words.front().place, "too few words", std::string(notation));
  FigureNumber number{.name = words[1].text, .query = {}, .place = words[1].place};
  if (number.name.find_first_not_of(of_a_name) != std::string::npos)
    throw InputError(number.place, fmt::format("'{}'", shown_start(number.name)), "a name of letters and digits");
  std::size_t event = 2;
  if (words[2].text == "angle") {
    number.kind = FigureNumber::Kind::angle;
    event = 3;
  } else if (words[2].text == "share") {
    if (words.size() < 5) throw InputError(words[2].place, "'share' with too few numbers", "share FROM TO");
    number.kind = FigureNumber::Kind::share;
    number.from = number_of(words[3]), number.to = number_of(words[4]);
    if (number.from == number.to) throw InputError(words[4].place, "a share of nothing", "another number");
    event = 5;
  }
  if (event >= words.size())
    throw InputError(words[event - 1].place, fmt::format("'{}' of nothing", words[2].text), "EVENT: NUMBER behind it");
  const SourcePlace& from = words[event].place;
  const auto begin = static_cast<std::size_t>(from.column - start.column);
  try {
    number.query = parse_field_query(line.substr(begin, sign - begin));
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}:{}:{}: {}", from.file, from.line, from.column, error.what()));
  }
  const SourcePlace last{start.file, start.line, start.column + static_cast<int>(sign) + 3};
  number.own = number_of({std::string(without_blanks(line.substr(sign + 3))), last});
  return number;
}

std::optional<double> number_at(const FigureNumber& number, const PixelStory& story) {
  std::optional<double> value = number_of_story(story.events, number.query);
  if (!value) return {};
  switch (number.kind) {
  case FigureNumber::Kind::itself:
    break;
  case FigureNumber::Kind::angle:
    *value = portable::acos(std::clamp(*value, -1.0, 1.0)) * 180 / std::numbers::pi;
    break;
  case FigureNumber::Kind::share:
    *value = (*value - number.from) / (number.to - number.from);
    break;
  }
  return std::isfinite(*value) ? value : std::nullopt;
}

std::string with_numbers(std::string_view text, const FigureNumbers& numbers, const SourcePlace& start, bool rounded) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    if (text[at] != '@') {
      result += text[at++];
      continue;
    }
    const std::size_t end = std::min(text.find_first_not_of(of_a_name, at + 1), text.size());
    const std::string_view name = text.substr(at + 1, end - at - 1);
    const auto found = numbers.find(name);
    if (found == numbers.end()) {
      std::vector<std::string_view> names;
      for (const auto& [known, number] : numbers) names.push_back(known);
      throw InputError({start.file, start.line, start.column + static_cast<int>(at)},
                       fmt::format("'@{}'", shown_start(name)),
                       "a number of a line 'pixel NAME EVENT: NUMBER = N' above" + did_you_mean(name, names, ""));
    }
    const bool turned = !rounded && !result.empty() && result.back() == '-';
    if (turned) result.pop_back();
    result += rounded ? rounded_number(found->second) : fmt::format("{}", turned ? -found->second : found->second);
    at = end;
  }
  return result;
}

}  // namespace ps
