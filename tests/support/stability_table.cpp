#include "support/stability_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <optional>
#include <sstream>
#include <utility>

#include <fmt/format.h>

#include "base/check.h"
#include "base/enumerators.h"
#include "base/number_text.h"

namespace ps::test {
namespace {

constexpr double endless = std::numeric_limits<double>::infinity();
constexpr std::string_view header = "experiment\tseries\tknob\tmethod\tkind\trule\tfigure\tallowance\tremark";
constexpr std::size_t columns = 9;

/// One line, with its place for messages.
class Row {
 public:
  Row(std::string_view line, std::string file, int number) : file_(std::move(file)), number_(number) {
    std::istringstream stream{std::string(line)};
    for (std::string field; std::getline(stream, field, '\t');) fields_.push_back(field);
    if (fields_.size() > columns) refuse(line, fmt::format("{} columns at most", columns));
    fields_.resize(columns);
  }

  StabilityFigure figure() const {
    StabilityFigure row;
    row.experiment = fields_[0];
    row.series = fields_[1];
    row.knob = fields_[2];
    row.method = one_of<FigureMethod>(fields_[3]);
    row.kind = one_of<FigureKind>(fields_[4]);
    row.rule = one_of<FigureRule>(fields_[5]);
    row.figure = fields_[6];
    row.allowance = fields_[7];
    row.remark = fields_[8];
    row.place = fmt::format("{}:{}", file_, number_);
    row.knobs = knobs(row);
    check_kind(row);
    row.accepts = accepted(row);
    return row;
  }

 private:
  [[noreturn]] void refuse(std::string_view found, const std::string& expected) const {
    throw InputError({file_, number_, 0}, fmt::format("'{}'", found), expected);
  }

  /// Rules of two words have a minus between them, kinds a blank.
  template <class Choice>
  Choice one_of(const std::string& field) const {
    std::string key;
    std::replace_copy(field.begin(), field.end(), std::back_inserter(key), ' ',
                      std::is_same_v<Choice, FigureKind> ? '-' : ' ');
    if (const auto choice = enumerator_named<Choice>(key)) return *choice;
    refuse(field, fmt::format("one of '{}'", fmt::join(enumerator_keys<Choice>, "' '")));
  }

  double number(std::string_view text) const {
    if (text == "-inf") return -endless;
    const std::optional<double> value = parse_number(text);
    if (!value) refuse(text, "a number");
    return *value;
  }

  FigureRange knobs(const StabilityFigure& row) const {
    const bool about_series = row.rule == FigureRule::rising || row.rule == FigureRule::falling;
    if (row.knob == "all") return {-endless, endless};
    if (const std::size_t dots = row.knob.find(".."); dots != std::string::npos)
      return {number(std::string_view(row.knob).substr(0, dots)), number(std::string_view(row.knob).substr(dots + 2))};
    if (about_series) refuse(row.knob, "'all' or LOW..HIGH");
    return {number(row.knob), number(row.knob)};
  }

  /// Which facts a kind of set-up can be held to.
  void check_kind(const StabilityFigure& row) const {
    const auto is = [&](std::initializer_list<FigureRule> some) {
      return std::find(some.begin(), some.end(), row.rule) != some.end();
    };
    using enum FigureRule;
    switch (row.kind) {
    case FigureKind::reproduced:
      if (!is({given, zero, above_zero, closed_form})) refuse(fields_[5], "given, zero, above-zero or closed-form");
      break;
    case FigureKind::ours:
      if (is({given})) refuse(fields_[5], "no figure of another measurement for a set-up of ours");
      break;
    case FigureKind::not_reached:
      if (!is({given})) refuse(fields_[5], "given");
      if (row.remark.empty()) refuse("", "a remark that says why");
      break;
    case FigureKind::reference:
      if (!is({closed_form, zero})) refuse(fields_[5], "closed-form or zero");
      break;
    }
  }

  /// "12 events", "0.5" or "2 %".
  struct Allowance {
    std::optional<int> events;
    double absolute = 0;
  };
  Allowance allowance(double figure) const {
    const std::string_view text = fields_[7];
    if (text.ends_with(" events")) {
      const double events = number(text.substr(0, text.size() - 7));
      if (!(events >= 1 && events == std::floor(events))) refuse(text, "a whole number of events");
      return {static_cast<int>(events), 0};
    }
    if (text.ends_with(" %")) return {{}, std::abs(figure) * number(text.substr(0, text.size() - 2)) / 100};
    return {{}, text.empty() ? 0 : number(text)};
  }

  FigureRange around(double figure, double low_factor, double high_factor) const {
    const double a = figure * low_factor, b = figure * high_factor;
    return {std::min(a, b), std::max(a, b)};
  }

  FigureRange accepted(const StabilityFigure& row) const {
    const bool events = row.allowance.ends_with("events");
    if (!row.allowance.empty() && events != (row.rule == FigureRule::given))
      refuse(row.allowance, "events for a given figure, a number for a closed form");
    switch (row.rule) {
    case FigureRule::zero:
      if (row.figure != "0" || !row.allowance.empty()) refuse(row.figure, "0 without an allowance");
      return {0, 0};
    case FigureRule::above_zero:
      return {std::numeric_limits<double>::denorm_min(), std::numeric_limits<double>::max()};
    case FigureRule::given: {
      const double figure = number(row.figure);
      const FigureRange wide = around(figure, 1 / 1.5, 1.5);
      if (!events) return wide;
      const int counted = *allowance(figure).events;
      const FigureRange chance = poisson_interval(counted);
      const FigureRange noisy = around(figure, chance.low / counted, chance.high / counted);
      return {std::min(wide.low, noisy.low), std::max(wide.high, noisy.high)};
    }
    case FigureRule::magnitude:
      return around(number(row.figure), 0.1, 10);
    case FigureRule::closed_form: {
      const double figure = number(row.figure);
      if (std::isinf(figure)) return {figure, figure};
      // Without an allowance the formula must come out in all digits that a sum of a few roundings leaves.
      const double off = row.allowance.empty() ? 1e-9 * std::abs(figure) : allowance(figure).absolute;
      return {figure - off, figure + off};
    }
    case FigureRule::rising:
    case FigureRule::falling:
    case FigureRule::above_robust:
      if (!row.figure.empty() || !row.allowance.empty()) refuse(row.figure, "no figure");
      break;
    }
    return {-endless, endless};
  }

  std::string file_;
  int number_;
  std::vector<std::string> fields_;
};

/// Share of a Poisson distribution at `events` or fewer. By logarithms, since exp(-mean) is 0 from a mean of 746 on.
double at_most(int events, double mean) {
  double sum = 0;
  for (int k = 0; k <= events; ++k) sum += std::exp(k * std::log(mean) - mean - std::lgamma(k + 1.0));
  return sum;
}

}  // namespace

std::vector<StabilityFigure> parse_stability_figures(std::string_view text, const std::string& name) {
  std::vector<StabilityFigure> figures;
  std::istringstream stream{std::string(text)};
  int number = 0;
  for (std::string line; std::getline(stream, line);) {
    if (++number == 1) {
      if (line != header) throw InputError({name, 1, 0}, fmt::format("'{}'", line), std::string(header));
      continue;
    }
    if (!line.empty() && line.front() != '#') figures.push_back(Row(line, name, number).figure());
  }
  return figures;
}

std::vector<StabilityFigure> read_stability_figures() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(PIXELSCOPE_TEST_DIR "/property/stability_figures"))
    if (entry.path().extension() == ".tsv") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::vector<StabilityFigure> all;
  for (const auto& file : files) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    for (StabilityFigure& figure : parse_stability_figures(text.str(), file.filename().string()))
      all.push_back(std::move(figure));
  }
  return all;
}

FigureRange poisson_interval(int events) {
  constexpr double tail = 0.00134989803163;  // of a normal distribution beyond three standard deviations, one side
  const auto where = [&](auto&& below, double high) {
    double low = 0;
    for (int i = 0; i < 200; ++i) {
      const double middle = (low + high) / 2;
      (below(middle) ? low : high) = middle;
    }
    return low;
  };
  const double far = events + 10 * std::sqrt(events + 1.0) + 10;
  FigureRange range;
  if (events > 0) range.low = where([&](double mean) { return 1 - at_most(events - 1, mean) < tail; }, events);
  range.high = where([&](double mean) { return at_most(events, mean) > tail; }, far);
  return range;
}

std::string kind_text(FigureKind kind) {
  std::string text(enumerator_key(kind));
  std::replace(text.begin(), text.end(), '-', ' ');
  return text;
}

}  // namespace ps::test
