#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/metric_words.h"
#include "options/option.h"
#include "record/value_text.h"
#include "study/stability/experiment.h"

namespace ps {
namespace {

constexpr double largest_in_full = 1e12;

std::string counted(const Metric& metric, std::string_view where) {
  return fmt::format("{} {}", counter_label(metric.counter), where);
}

/// "red of A's pixel", "mean red of A in 10 x 10 pixels"
std::string level_words(const Metric& metric, std::string_view channel, std::string_view side) {
  if (!metric.within) return fmt::format("{} level of {} at the picked pixel", channel, side);
  return fmt::format("mean {} level of {} in the rectangle", channel, side);
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
  case MetricKind::counter_a:
    return counted(metric, "in A");
  case MetricKind::counter_b:
    return counted(metric, "in B");
  case MetricKind::counter_ratio:
    return counted(metric, "in A, divided by those in B");
  case MetricKind::false_shadow_pixels:
    return "pixels of A in a false shadow";
  case MetricKind::red_a:
    return level_words(metric, "red", "A");
  case MetricKind::green_a:
    return level_words(metric, "green", "A");
  case MetricKind::blue_a:
    return level_words(metric, "blue", "A");
  case MetricKind::red_b:
    return level_words(metric, "red", "B");
  case MetricKind::green_b:
    return level_words(metric, "green", "B");
  case MetricKind::blue_b:
    return level_words(metric, "blue", "B");
  case MetricKind::object_a:
    return "index of the object at A's picked pixel";
  case MetricKind::object_b:
    return "index of the object at B's picked pixel";
  case MetricKind::triangle_a:
    return "index of the triangle at A's picked pixel";
  case MetricKind::triangle_b:
    return "index of the triangle at B's picked pixel";
  case MetricKind::winner_a:
    return fmt::format("A's picked pixel shows {} (1 = yes)", metric.name);
  case MetricKind::winner_b:
    return fmt::format("B's picked pixel shows {} (1 = yes)", metric.name);
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

std::string mutation_words(const Mutation& mutation) {
  constexpr std::string_view put_back = "default ";
  std::string words;
  for (std::size_t from = 0; from < mutation.text.size();) {
    const std::size_t end = std::min(mutation.text.find("; ", from), mutation.text.size());
    std::string part = mutation.text.substr(from, end - from);
    const Option* option = part.starts_with(put_back) ? find_option(part.substr(put_back.size())) : nullptr;
    if (option) part = fmt::format("{} at its default", option->label);
    words += (words.empty() ? "" : "; ") + part;
    from = end + 2;
  }
  return words;
}

std::string measured_text(double value) {
  if (value == std::round(value) && std::abs(value) < largest_in_full) return fmt::format("{:.0f}", value + 0.0);
  return number_text(value);
}

}  // namespace ps
