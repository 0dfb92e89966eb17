#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "base/counters.h"
#include "base/progress.h"
#include "document/document.h"

/// The metrics of lessons: numbers on the pictures A and B, and the bounds that they keep.

namespace ps {

class MeasuredPictures;

/// A number that can be measured on the pictures A and B of a document.
enum class MetricKind {
  differing_pixels,     ///< pixels whose display levels differ between A and B
  mean_difference,      ///< mean absolute difference of A and B, display levels
  max_difference,       ///< largest difference of one channel, display levels
  psnr,                 ///< peak signal-to-noise ratio of B against A, dB; infinite where they are equal
  flip,                 ///< mean of FLIP's perceived difference, 0 to 1
  counter,              ///< a Counter of a side
  counter_ratio,        ///< a Counter of A divided by that of B
  false_shadow_pixels,  ///< pixels of A in a shadow that is not there in double precision without self-hits
  red,                  ///< of a side: display levels of the picked pixel, or their mean over a rectangle
  green,
  blue,
  object,     ///< index of the object that a side's picked pixel shows; -1 = background
  triangle,   ///< index of the triangle there
  winner,     ///< 1 if a side's picked pixel shows the object of this name ("background" for none), else 0
  experiment  ///< a point of a stability experiment's curve
};

/// Which of the two methods of a stability experiment.
enum class StudyMethod { naive, robust };

struct Metric {
  MetricKind kind = MetricKind::differing_pixels;
  Side side = Side::a;                      ///< of the metrics that read one picture
  Counter counter = Counter::eye_rays;      ///< of the counter metrics
  std::string name;                         ///< of the winner, or key of the experiment
  StudyMethod method = StudyMethod::naive;  ///< of the experiment, as all that follows
  double knob = 0;
  std::string series;
  std::optional<TileRect> within;  ///< only these pixels, for metrics that compare pictures or read levels
  bool operator==(const Metric&) const = default;
};

/// Reads what follows `metric`: its name, and what it needs: "counter-a eye-rays", "winner-a red sphere",
/// "experiment ground-sphere-acne naive 0.001 acne". Throws InputError without a place, naming the metrics there are.
Metric parse_metric(std::string_view text);
/// "counter-a eye-rays"
std::string metric_text(const Metric& metric);
/// Whether `within` can be set.
bool reads_pictures(MetricKind kind);
/// Whether it depends on which pixel is picked.
bool reads_pixel(const Metric& metric);

/// The condition on a number. `equals` allows a tolerance on both sides.
struct Bound {
  enum class Kind { at_least, at_most, equals };
  Kind kind = Kind::at_least;
  double number = 0, tolerance = 0;
  bool holds(double value) const;
  bool operator==(const Bound&) const = default;
};
/// Reads ">= 1000", "<= 3", "= 121" or "= 0.333 +- 0.001". Throws InputError without a place.
Bound parse_bound(std::string_view text);
/// ">= 1000"
std::string bound_text(const Bound& bound);

/// Measures on the pictures of `document`. Throws InputError where that cannot be (no pixel is picked, a renderer does
/// not count this, an experiment has no such point) and Cancelled. `pictures`: what earlier measurements have rendered.
double measure(const Metric& metric, const Document& document, Progress& progress,
               MeasuredPictures* pictures = nullptr);

/// For each pixel whether the metric, measured as if that pixel were picked, keeps the bound: 1 or 0. Throws InputError
/// for metrics that read no single pixel, and Cancelled.
Image<unsigned char> places_within(const Metric& metric, const Bound& bound, const Document& document,
                                   Progress& progress, MeasuredPictures* pictures = nullptr);

}  // namespace ps
