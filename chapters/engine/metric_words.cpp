#include <fmt/format.h>

#include <cmath>

#include "base/number_text.h"
#include "engine/metric_words.h"
#include "record/value_text.h"
#include "study/stability/experiment.h"

namespace ps {
namespace {

constexpr double largest_in_full = 1e12;

char letter_of(const Metric& metric) { return metric.side == Side::a ? 'A' : 'B'; }

std::string counted(const Metric& metric, std::string_view where) {
  return fmt::format("{} {}", counter_label(metric.counter), where);
}

std::string level_words(const Metric& metric, std::string_view channel) {
  if (!metric.within) return fmt::format("{} level of {} at the picked pixel", channel, letter_of(metric));
  return fmt::format("mean {} level of {} in the rectangle", channel, letter_of(metric));
}

std::string compared_words(const Metric& metric, std::string_view what) {
  return fmt::format("{}{}", what, metric.within ? " in the rectangle" : "");
}

}  // namespace

std::string metric_words(const Metric& metric) {
  switch (metric.kind) {
  case MetricKind::differing_pixels:
    return compared_words(metric, "pixels that differ");
  case MetricKind::mean_difference:
    return compared_words(metric, "mean difference in levels");
  case MetricKind::max_difference:
    return compared_words(metric, "largest difference in levels");
  case MetricKind::psnr:
    return compared_words(metric, "PSNR in dB");
  case MetricKind::flip:
    return compared_words(metric, "mean FLIP difference");
  case MetricKind::counter:
    return counted(metric, metric.side == Side::a ? "in A" : "in B");
  case MetricKind::counter_ratio:
    return counted(metric, "in A, divided by those in B");
  case MetricKind::false_shadow_pixels:
    return "pixels of A in a false shadow";
  case MetricKind::red:
    return level_words(metric, "red");
  case MetricKind::green:
    return level_words(metric, "green");
  case MetricKind::blue:
    return level_words(metric, "blue");
  case MetricKind::object:
    return fmt::format("index of the object at {}'s picked pixel", letter_of(metric));
  case MetricKind::triangle:
    return fmt::format("index of the triangle at {}'s picked pixel", letter_of(metric));
  case MetricKind::winner:
    return fmt::format("{}'s picked pixel shows {}", letter_of(metric), metric.name);
  case MetricKind::experiment:
    return fmt::format("{} ({}) at {} in the experiment '{}'", metric.series,
                       metric.method == StudyMethod::naive ? "naive" : "robust", number_text(metric.knob),
                       find_stability_experiment(metric.name).title);
  }
  return {};
}

std::string bound_words(const Bound& bound) {
  switch (bound.kind) {
  case Bound::Kind::at_least:
    return "at least " + measured_text(bound.number);
  case Bound::Kind::at_most:
    return "at most " + measured_text(bound.number);
  case Bound::Kind::equals:
    return bound.tolerance > 0 ? fmt::format("{} ± {}", measured_text(bound.number), measured_text(bound.tolerance))
                               : measured_text(bound.number);
  }
  return {};
}

std::string value_words(const Metric& metric, double value) {
  if (metric.kind != MetricKind::winner) return measured_text(value);
  return value == 0 ? "no" : "yes";
}

std::string demand_words(const Metric& metric, const Bound& bound) {
  if (metric.kind != MetricKind::winner) return bound_words(bound);
  return bound.holds(1) ? "yes" : "no";
}

std::string measured_text(double value) {
  if (value != std::round(value) || std::abs(value) >= largest_in_full) return number_text(value);
  return (value < 0 ? "-" : "") + with_thousands(fmt::format("{:.0f}", std::abs(value)));
}

}  // namespace ps
