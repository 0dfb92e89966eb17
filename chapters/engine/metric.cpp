#include "engine/metric.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "base/check.h"
#include "base/number_text.h"
#include "base/spelling.h"
#include "engine/words.h"
#include "record/value_text.h"
#include "study/stability/experiment.h"

namespace ps {
namespace {

/// A word of the notation and what it means.
struct MetricKey {
  std::string_view key;
  MetricKind kind;
  Side side = Side::a;
};

constexpr MetricKey metric_keys[]{{"differing-pixels", MetricKind::differing_pixels},
                                  {"mean-difference", MetricKind::mean_difference},
                                  {"max-difference", MetricKind::max_difference},
                                  {"psnr", MetricKind::psnr},
                                  {"flip", MetricKind::flip},
                                  {"counter-a", MetricKind::counter},
                                  {"counter-b", MetricKind::counter, Side::b},
                                  {"counter-ratio", MetricKind::counter_ratio},
                                  {"false-shadow-pixels", MetricKind::false_shadow_pixels},
                                  {"red-a", MetricKind::red},
                                  {"green-a", MetricKind::green},
                                  {"blue-a", MetricKind::blue},
                                  {"red-b", MetricKind::red, Side::b},
                                  {"green-b", MetricKind::green, Side::b},
                                  {"blue-b", MetricKind::blue, Side::b},
                                  {"object-a", MetricKind::object},
                                  {"object-b", MetricKind::object, Side::b},
                                  {"triangle-a", MetricKind::triangle},
                                  {"triangle-b", MetricKind::triangle, Side::b},
                                  {"winner-a", MetricKind::winner},
                                  {"winner-b", MetricKind::winner, Side::b},
                                  {"experiment", MetricKind::experiment}};

std::string_view key_of(const Metric& metric) {
  const auto* const found = std::find_if(std::begin(metric_keys), std::end(metric_keys), [&](const MetricKey& each) {
    return each.kind == metric.kind && each.side == metric.side;
  });
  PS_ASSERT(found != std::end(metric_keys), "metrics of both pictures have side A");
  return found->key;
}

bool counts(MetricKind kind) { return kind == MetricKind::counter || kind == MetricKind::counter_ratio; }

/// The source of a metric.
enum class MetricSource { two_pictures, level, id, other };

MetricSource metric_source(MetricKind kind) {
  switch (kind) {
  case MetricKind::differing_pixels:
  case MetricKind::mean_difference:
  case MetricKind::max_difference:
  case MetricKind::psnr:
  case MetricKind::flip:
    return MetricSource::two_pictures;
  case MetricKind::red:
  case MetricKind::green:
  case MetricKind::blue:
    return MetricSource::level;
  case MetricKind::object:
  case MetricKind::triangle:
  case MetricKind::winner:
    return MetricSource::id;
  case MetricKind::counter:
  case MetricKind::counter_ratio:
  case MetricKind::false_shadow_pixels:
  case MetricKind::experiment:
    break;
  }
  return MetricSource::other;
}

Counter parse_counter(std::string_view key) {
  for (std::size_t i = 0; i < counter_count; ++i)
    if (counter_key(static_cast<Counter>(i)) == key) return static_cast<Counter>(i);
  throw InputError(fmt::format("'{}' is not a counter", key));
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
  const auto* const found = std::find_if(std::begin(metric_keys), std::end(metric_keys),
                                         [&](const MetricKey& each) { return each.key == key; });
  if (found == std::end(metric_keys)) {
    std::string known;
    for (const MetricKey& each : metric_keys) known.append(" ").append(each.key);
    throw InputError(fmt::format("'{}' is not a metric, expected one of{}", key, known));
  }
  Metric metric;
  metric.kind = found->kind;
  metric.side = found->side;
  if (counts(metric.kind))
    metric.counter = parse_counter(rest);
  else if (metric.kind == MetricKind::experiment)
    read_experiment(rest, metric);
  else if (metric.kind == MetricKind::winner) {
    if (rest.empty()) throw InputError(fmt::format("found '{}', expected the name of an object behind it", key));
    metric.name = rest;
  } else if (!rest.empty())
    throw InputError(fmt::format("found '{}' after the metric, expected nothing", rest));
  return metric;
}

std::string metric_text(const Metric& metric) {
  const std::string_view key = key_of(metric);
  if (counts(metric.kind)) return fmt::format("{} {}", key, counter_key(metric.counter));
  if (metric.kind == MetricKind::winner) return fmt::format("{} {}", key, metric.name);
  if (metric.kind != MetricKind::experiment) return std::string(key);
  return fmt::format("{} {} {} {} {}", key, metric.name, metric.method == StudyMethod::naive ? "naive" : "robust",
                     exact_number_text(metric.knob), metric.series);
}

bool reads_pictures(MetricKind kind) {
  const MetricSource source = metric_source(kind);
  return source == MetricSource::two_pictures || source == MetricSource::level;
}

bool reads_pixel(const Metric& metric) {
  const MetricSource source = metric_source(metric.kind);
  return source == MetricSource::id || (source == MetricSource::level && !metric.within);
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
