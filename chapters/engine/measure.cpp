#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <vector>

#include "base/check.h"
#include "engine/measured_pictures.h"
#include "engine/metric.h"
#include "frame/display_frame.h"
#include "frame/region.h"
#include "image/difference.h"
#include "image/metrics.h"
#include "options/renderer_kind.h"
#include "record/value_text.h"
#include "study/stability/experiment.h"

namespace ps {
namespace {

/// Renders sides of a document, and only what a metric asks for.
class Bench {
 public:
  Bench(const Document& document, Progress& progress, MeasuredPictures* pictures)
      : document_(document), progress_(progress), pictures_(pictures ? *pictures : own_) {}
  Bench(const Bench&) = delete;
  Bench& operator=(const Bench&) = delete;

  const Document& document() const { return document_; }
  std::shared_ptr<const Frame> frame(const Settings& settings, Channel channels = Channel::none) {
    return pictures_.frame(document_, settings, channels, progress_);
  }
  std::shared_ptr<const Frame> frame(Side side, Channel channels = Channel::none) {
    return frame(settings(side), channels);
  }
  Image<Rgb8> levels(Side side) { return display_frame(*frame(side), settings(side)); }
  const Settings& settings(Side side) const { return side_of(document_, side).settings; }

  Vec2i pixel() const {
    const View view = view_of(document_);
    const Vec2i p = document_.pixel;
    if (p.x < 0 || p.y < 0 || p.x >= view.width || p.y >= view.height)
      throw InputError("the metric reads a pixel, but none inside the picture is picked");
    return p;
  }

 private:
  const Document& document_;
  Progress& progress_;
  MeasuredPictures own_;
  MeasuredPictures& pictures_;
};

/// A's shadows against those in double precision with rays that start outside the surface's rounding error. Only pixels
/// that show the same object in both are counted.
double false_shadow_pixels(Bench& bench) {
  Settings exact = bench.settings(Side::a);
  exact.precision = Precision::float64;
  exact.self_hit = SelfHit::offset;
  exact.sphere_test = SphereTest::robust;
  const Channel channels = Channel::shadow | Channel::ids;
  const auto tested_frame = bench.frame(Side::a, channels), reference_frame = bench.frame(exact, channels);
  const Frame &tested = *tested_frame, &reference = *reference_frame;
  double count = 0;
  for (int y = 0; y < tested.height(); ++y)
    for (int x = 0; x < tested.width(); ++x)
      if (tested.ids.at(x, y) == reference.ids.at(x, y) && (tested.shadow.at(x, y) & ~reference.shadow.at(x, y)) != 0)
        ++count;
  return count;
}

bool counts_rays(Counter counter) {
  constexpr CounterSet rays{Counter::eye_rays, Counter::shadow_rays, Counter::reflection_rays,
                            Counter::refraction_rays};
  return rays.contains(counter);
}

double count_of(Bench& bench, Side side, Counter counter) {
  if (const auto count = bench.frame(side)->counters.get(counter)) return static_cast<double>(*count);
  // A renderer of fragments sends no ray: a claim may compare it with one that does.
  if (counts_rays(counter) && picture_way(bench.settings(side).renderer) == PictureWay::fragments) return 0;
  throw InputError(fmt::format("metric: the picture's renderer does not count {}", counter_key(counter)));
}

/// The rectangle of a metric in a picture of this size. Throws InputError where it does not lie inside.
TileRect rectangle_in(const Vec2i& size, const TileRect& within) {
  const TileRect inside = common_part(within, {0, 0, size.x, size.y});
  if (!(inside == within) || is_empty(inside))
    throw InputError(
        fmt::format("within: the rectangle does not lie in the picture of {} x {} pixels", size.x, size.y));
  return inside;
}

Image<Rgb8> part_of_picture(const Image<Rgb8>& picture, const std::optional<TileRect>& within) {
  if (!within) return picture;
  const TileRect inside = rectangle_in({picture.width(), picture.height()}, *within);
  Image<Rgb8> part(inside.width(), inside.height());
  for (int y = 0; y < part.height(); ++y)
    for (int x = 0; x < part.width(); ++x) part.at(x, y) = picture.at(inside.x0 + x, inside.y0 + y);
  return part;
}

Comparison compared(Bench& bench, const Metric& metric) {
  return compare_channels(part_of_picture(bench.levels(Side::a), metric.within),
                          part_of_picture(bench.levels(Side::b), metric.within));
}

int level_of(Rgb8 colour, int channel) { return channel == 0 ? colour.r : channel == 1 ? colour.g : colour.b; }

/// The index of the object of that name; -1 for "background".
int object_of_name(const Scene& scene, std::string_view name) {
  const auto& objects = scene.geometry->objects;
  for (std::size_t i = 0; i < objects.size(); ++i)
    if (objects[i].name == name) return static_cast<int>(i);
  if (name == "background") return -1;
  throw InputError(fmt::format("winner: the scene has no object named '{}'", name));
}

double experiment_value(const Metric& metric, Progress& progress) {
  StabilityRun run;
  run.progress = &progress;
  const StabilityExperiment& experiment = find_stability_experiment(metric.name);
  std::vector<std::string> known;
  for (const StabilityRow& row : experiment.measure(run)) {
    known.push_back(fmt::format("{} {}", exact_number_text(row.knob), row.series));
    if (row.series != metric.series || std::abs(row.knob - metric.knob) > 1e-9 * std::abs(metric.knob)) continue;
    const double value = metric.method == StudyMethod::naive ? row.naive : row.robust;
    if (!std::isnan(value)) return value;
  }
  throw InputError(
      fmt::format("metric: the experiment '{}' has no such point; it has {}", metric.name, fmt::join(known, ", ")));
}

using ValueAt = std::function<double(int x, int y)>;

ValueAt levels_at(Bench& bench, Side side, int channel) {
  return [picture = bench.levels(side), channel](int x, int y) { return level_of(picture.at(x, y), channel); };
}

ValueAt ids_at(Bench& bench, Side side, const std::function<double(const PixelId&)>& value) {
  return [ids = bench.frame(side, Channel::ids)->ids, value](int x, int y) { return value(ids.at(x, y)); };
}

/// The number that the metric reads at each pixel.
ValueAt values_of(Bench& bench, const Metric& metric) {
  switch (metric.kind) {
  case MetricKind::red:
    return levels_at(bench, metric.side, 0);
  case MetricKind::green:
    return levels_at(bench, metric.side, 1);
  case MetricKind::blue:
    return levels_at(bench, metric.side, 2);
  case MetricKind::object:
    return ids_at(bench, metric.side, [](const PixelId& id) { return id.object; });
  case MetricKind::triangle:
    return ids_at(bench, metric.side, [](const PixelId& id) { return id.triangle; });
  case MetricKind::winner: {
    const int wanted = object_of_name(bench.document().scene, metric.name);
    return ids_at(bench, metric.side, [wanted](const PixelId& id) { return id.object == wanted ? 1 : 0; });
  }
  case MetricKind::differing_pixels:
  case MetricKind::max_difference: {
    const bool counted = metric.kind == MetricKind::differing_pixels;
    return [a = bench.levels(Side::a), b = bench.levels(Side::b), counted](int x, int y) {
      const int most = largest_difference(a.at(x, y), b.at(x, y));
      return counted ? std::min(most, 1) : most;
    };
  }
  case MetricKind::mean_difference:
  case MetricKind::psnr:
  case MetricKind::flip:
  case MetricKind::counter:
  case MetricKind::counter_ratio:
  case MetricKind::false_shadow_pixels:
  case MetricKind::experiment:
    break;
  }
  throw InputError(fmt::format("'{}' does not read a single pixel", metric_text(metric)));
}

/// The number that the metric reads at the picked pixel, or its mean over its rectangle.
double picked_value(Bench& bench, const Metric& metric) {
  if (!metric.within) {
    const Vec2i pixel = bench.pixel();
    return values_of(bench, metric)(pixel.x, pixel.y);
  }
  const View view = view_of(bench.document());
  const TileRect part = rectangle_in({view.width, view.height}, *metric.within);
  const ValueAt value = values_of(bench, metric);
  double sum = 0;
  for (int y = part.y0; y < part.y1; ++y)
    for (int x = part.x0; x < part.x1; ++x) sum += value(x, y);
  return sum / (static_cast<double>(part.width()) * part.height());
}

}  // namespace

double measure(const Metric& metric, const Document& document, Progress& progress, MeasuredPictures* pictures) {
  Bench bench(document, progress, pictures);
  switch (metric.kind) {
  case MetricKind::differing_pixels:
    return static_cast<double>(compared(bench, metric).differing);
  case MetricKind::mean_difference:
    return compared(bench, metric).mae;
  case MetricKind::max_difference:
    return compared(bench, metric).max;
  case MetricKind::psnr:
    return compared(bench, metric).psnr.value_or(std::numeric_limits<double>::infinity());
  case MetricKind::flip:
    return compare_images(part_of_picture(bench.levels(Side::a), metric.within),
                          part_of_picture(bench.levels(Side::b), metric.within))
        .flip;
  case MetricKind::counter:
    return count_of(bench, metric.side, metric.counter);
  case MetricKind::counter_ratio:
    return count_of(bench, Side::a, metric.counter) / count_of(bench, Side::b, metric.counter);
  case MetricKind::false_shadow_pixels:
    return false_shadow_pixels(bench);
  case MetricKind::red:
  case MetricKind::green:
  case MetricKind::blue:
  case MetricKind::object:
  case MetricKind::triangle:
  case MetricKind::winner:
    return picked_value(bench, metric);
  case MetricKind::experiment:
    return experiment_value(metric, progress);
  }
  return std::nan("");
}

Image<unsigned char> places_within(const Metric& metric, const Bound& bound, const Document& document,
                                   Progress& progress, MeasuredPictures* pictures) {
  Bench bench(document, progress, pictures);
  const ValueAt value = values_of(bench, metric);
  const View view = view_of(document);
  Image<unsigned char> places(view.width, view.height);
  for (int y = 0; y < view.height; ++y)
    for (int x = 0; x < view.width; ++x) places.at(x, y) = bound.holds(value(x, y)) ? 1 : 0;
  return places;
}

}  // namespace ps
