#include "engine/metric.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "base/check.h"
#include "base/number_text.h"
#include "base/spelling.h"
#include "record/value_text.h"
#include "study/stability/experiment.h"

namespace ps {
namespace {

constexpr std::array<std::string_view, 22> metric_keys{"differing-pixels",
                                                       "mean-difference",
                                                       "max-difference",
                                                       "psnr",
                                                       "flip",
                                                       "counter-a",
                                                       "counter-b",
                                                       "counter-ratio",
                                                       "false-shadow-pixels",
                                                       "red-a",
                                                       "green-a",
                                                       "blue-a",
                                                       "red-b",
                                                       "green-b",
                                                       "blue-b",
                                                       "object-a",
                                                       "object-b",
                                                       "triangle-a",
                                                       "triangle-b",
                                                       "winner-a",
                                                       "winner-b",
                                                       "experiment"};

std::string_view key_of(MetricKind kind) { return metric_keys.at(static_cast<std::size_t>(kind)); }

bool counts(MetricKind kind) {
  return kind == MetricKind::counter_a || kind == MetricKind::counter_b || kind == MetricKind::counter_ratio;
}
bool names_winner(MetricKind kind) { return kind == MetricKind::winner_a || kind == MetricKind::winner_b; }

Counter parse_counter(std::string_view key) {
  for (std::size_t i = 0; i < counter_count; ++i)
    if (counter_key(static_cast<Counter>(i)) == key) return static_cast<Counter>(i);
  throw InputError(fmt::format("'{}' is not a counter", key));
}

/// The first word of a text, which is cut off with the spaces behind it.
std::string_view take_word(std::string_view& text) {
  const auto end = std::min(text.find(' '), text.size());
  const std::string_view word = text.substr(0, end);
  text.remove_prefix(std::min(text.find_first_not_of(' ', end), text.size()));
  return word;
}

void read_experiment(std::string_view rest, Metric& metric) {
  const std::string_view all = rest;
  metric.name = find_stability_experiment(take_word(rest)).key;
  const std::string_view method = take_word(rest);
  const auto knob = parse_number(take_word(rest));
  if ((method != "naive" && method != "robust") || !knob || rest.empty())
    throw InputError(
        fmt::format("found 'experiment {}', expected its key, naive or robust, a value of its knob and the "
                    "name of a series",
                    all));
  metric.method = method == "naive" ? StudyMethod::naive : StudyMethod::robust;
  metric.knob = *knob;
  metric.series = rest;
}

}  // namespace

Metric parse_metric(std::string_view text) {
  std::string_view rest = text;
  const std::string_view key = take_word(rest);
  const auto* const found = std::find(metric_keys.begin(), metric_keys.end(), key);
  if (found == metric_keys.end())
    throw InputError(fmt::format("'{}' is not a metric, expected one of {}", key, fmt::join(metric_keys, " ")));
  Metric metric;
  metric.kind = static_cast<MetricKind>(found - metric_keys.begin());
  if (counts(metric.kind))
    metric.counter = parse_counter(rest);
  else if (metric.kind == MetricKind::experiment)
    read_experiment(rest, metric);
  else if (names_winner(metric.kind)) {
    if (rest.empty()) throw InputError(fmt::format("found '{}', expected the name of an object behind it", key));
    metric.name = rest;
  } else if (!rest.empty())
    throw InputError(fmt::format("found '{}' after the metric, expected nothing", rest));
  return metric;
}

std::string metric_text(const Metric& metric) {
  const std::string_view key = key_of(metric.kind);
  if (counts(metric.kind)) return fmt::format("{} {}", key, counter_key(metric.counter));
  if (names_winner(metric.kind)) return fmt::format("{} {}", key, metric.name);
  if (metric.kind != MetricKind::experiment) return std::string(key);
  return fmt::format("{} {} {} {} {}", key, metric.name, metric.method == StudyMethod::naive ? "naive" : "robust",
                     exact_number_text(metric.knob), metric.series);
}

bool reads_pictures(MetricKind kind) {
  switch (kind) {
  case MetricKind::differing_pixels:
  case MetricKind::mean_difference:
  case MetricKind::max_difference:
  case MetricKind::psnr:
  case MetricKind::flip:
  case MetricKind::red_a:
  case MetricKind::green_a:
  case MetricKind::blue_a:
  case MetricKind::red_b:
  case MetricKind::green_b:
  case MetricKind::blue_b:
    return true;
  case MetricKind::counter_a:
  case MetricKind::counter_b:
  case MetricKind::counter_ratio:
  case MetricKind::false_shadow_pixels:
  case MetricKind::object_a:
  case MetricKind::object_b:
  case MetricKind::triangle_a:
  case MetricKind::triangle_b:
  case MetricKind::winner_a:
  case MetricKind::winner_b:
  case MetricKind::experiment:
    return false;
  }
  return false;
}

bool Bound::holds(double value) const {
  switch (kind) {
  case Kind::at_least:
    return value >= number;
  case Kind::at_most:
    return value <= number;
  case Kind::equals:
    return std::abs(value - number) <= tolerance;
  }
  return false;
}

Bound parse_bound(std::string_view text) {
  std::string_view rest = text;
  const std::string_view sign = take_word(rest);
  Bound bound;
  if (sign == ">=")
    bound.kind = Bound::Kind::at_least;
  else if (sign == "<=")
    bound.kind = Bound::Kind::at_most;
  else if (sign == "=")
    bound.kind = Bound::Kind::equals;
  else
    throw InputError(fmt::format("found '{}', expected >=, <= or = and a number", text));
  const auto number = parse_number(take_word(rest));
  if (!number) throw InputError(fmt::format("found '{}', expected >=, <= or = and a number", text));
  bound.number = *number;
  if (rest.empty()) return bound;
  const bool plus_minus = take_word(rest) == "+-" && bound.kind == Bound::Kind::equals;
  const auto tolerance = plus_minus ? parse_number(rest) : std::nullopt;
  if (!tolerance || *tolerance < 0)
    throw InputError(fmt::format("found '{}', expected nothing behind the number, or '= NUMBER +- TOLERANCE'", text));
  bound.tolerance = *tolerance;
  return bound;
}

std::string bound_text(const Bound& bound) {
  switch (bound.kind) {
  case Bound::Kind::at_least:
    return ">= " + number_text(bound.number);
  case Bound::Kind::at_most:
    return "<= " + number_text(bound.number);
  case Bound::Kind::equals:
    return bound.tolerance > 0 ? fmt::format("= {} +- {}", number_text(bound.number), number_text(bound.tolerance))
                               : "= " + number_text(bound.number);
  }
  return "";
}

}  // namespace ps
