#include "study/estimate.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "frame/display_frame.h"
#include "options/renderer_kind.h"
#include "study/model/held_pictures.h"
#include "study/model/model_needs.h"
#include "study/needs_truth.h"
#include "study/same_machinery.h"
#include "study/study_frame.h"
#include "study/view_pixels.h"
#include "study/worst_tile.h"

namespace ps {
namespace {

constexpr int small_part = 8, larger_part = 4;      // of the sides
constexpr int least_small = 32, least_larger = 64;  // px
constexpr int tries = 3;                            // of each size; the quickest counts, as others were disturbed
constexpr double short_try = 0.05;                  // seconds; what takes longer is tried once
constexpr int most_samples_tried = 16;

/// Seconds of a picture by its size.
struct PictureTime {
  double start = 0, per_pixel = 0;
  double prepare = 0;  ///< once: trees, mips, tessellations
  double of(double pixels) const { return start + per_pixel * pixels; }
};

/// A part of the sides, but at least `least` pixels, so that a renderer is busy with them and not with its threads.
View smaller(const View& view, int part, int least) {
  View small = view;
  small.width = std::max(std::min(view.width, least), view.width / part);
  small.height = std::max(std::min(view.height, least), view.height / part);
  return small;
}

/// Times small pictures of one scene.
class Trial {
 public:
  Trial(const Scene& scene, const View& view, WorkerPriority priority, StudyControl& control, const Clock& clock)
      : scene_(scene), view_(view), priority_(priority), control_(control), clock_(clock) {}

  PictureTime time_of(const Settings& settings) {
    const View small = smaller(view_, small_part, least_small), larger = smaller(view_, larger_part, least_larger);
    Prepared prepared;
    const double first = seconds(small, settings, prepared);
    const double little = quickest(small, settings, prepared);
    seconds(larger, settings, prepared);
    const double more = quickest(larger, settings, prepared);
    const double more_pixels = pixels_of(larger) - pixels_of(small);
    PictureTime time;
    time.per_pixel = more_pixels > 0 ? (more - little) / more_pixels : 0;
    // Without growth that the clock shows, all of the larger picture's time is taken to be that of its pixels.
    if (time.per_pixel <= 0) time.per_pixel = more / pixels_of(larger);
    time.start = std::max(0.0, more - time.per_pixel * pixels_of(larger));
    time.prepare = std::max(0.0, first - little);
    return time;
  }

  /// Of a picture of the whole view.
  double seconds_of(const Settings& settings) {
    const PictureTime time = time_of(settings);
    return time.of(pixels_of(view_));
  }

  /// Seconds that `compare` takes for two pictures of the whole view.
  template <class Compare>
  double comparing(const Settings& settings, const Compare& compare) {
    const View small = smaller(view_, larger_part, least_larger);
    Prepared prepared;
    const Frame frame = study_frame(scene_, small, settings, control_, priority_, prepared);
    const MeasuredPicture picture{display_frame(frame, settings), frame.colour};
    const double start = clock_();
    compare(picture);
    return (clock_() - start) * pixels_of(view_) / pixels_of(small);
  }

  ReferencePlan affordable(const ReferencePlan& plan) {
    RenderRequest how;
    how.priority = priority_;
    Prepared prepared;
    return ps::affordable(plan, scene_, view_, how, prepared, control_.progress());
  }

  double pixels() const { return pixels_of(view_); }

 private:
  double quickest(const View& view, const Settings& settings, Prepared& prepared) {
    double best = seconds(view, settings, prepared);
    for (int i = 1; i < tries && best < short_try; ++i) best = std::min(best, seconds(view, settings, prepared));
    return best;
  }

  double seconds(const View& view, const Settings& settings, Prepared& prepared) {
    control_.wait_here();  // not within what is timed
    const double start = clock_();
    study_frame(scene_, view, settings, control_, priority_, prepared);
    return clock_() - start;
  }

  const Scene& scene_;
  const View& view_;
  WorkerPriority priority_;
  StudyControl& control_;
  const Clock& clock_;
};

/// The runs of one point as run_chart() makes them: the picture, calls that fill a sample, and samples, each after a
/// run that is not timed.
double chart_point_seconds(double picture, int repeats, double shortest_sample) {
  int calls = 1;
  double sum = 2 * picture;  // for the error, and cold
  if (picture <= 4 * shortest_sample) {
    double taken = picture;
    sum += taken;
    while (taken < shortest_sample && picture > 0) {
      calls *= 2;
      taken = calls * picture;
      sum += taken;
    }
  }
  sum += calls * picture;
  return sum + (repeats - 1) * (1 + calls) * picture;
}

double reference_seconds(const ReferencePlan& planned, Trial& trial) {
  const ReferencePlan plan = trial.affordable(planned);
  Settings settings = plan.settings;
  if (plan.samples == 1) return trial.seconds_of(settings);
  if (!sends_rays(settings.renderer)) return trial.time_of(settings).of(plan.samples * trial.pixels());
  settings.samples_per_pixel = std::min(plan.samples, most_samples_tried);
  const double more = static_cast<double>(plan.samples) / settings.samples_per_pixel;
  return 2 * more * trial.seconds_of(settings);
}

}  // namespace

StudyEstimate estimate_chart(const ChartRequest& request, StudyControl& control, const Clock& clock) {
  const SceneTraits traits = scene_traits(request.scene);
  Trial trial(request.scene, request.view, request.priority, control, clock);
  std::vector<Settings> settings;
  std::vector<std::string> labels;
  for (const SweepPoint& point : request.points) {
    settings.push_back(point.value);
    labels.push_back(point.label);
  }
  const TimedSettings timed = on_same_machinery(settings, labels, traits, request.machinery);
  StudyEstimate estimate;
  if (settings.empty()) return estimate;
  const double compare = trial.comparing(timed.settings.front(), [&](const MeasuredPicture& picture) {
    compare_pictures(picture, picture, {request.error.metric, request.error.values, {}});
  });
  estimate.seconds = compare;
  if (request.reference.file.empty())
    estimate.seconds +=
        reference_seconds(plan_reference(request.points, request.base, traits, request.view, request.reference), trial);
  for (std::size_t i = 0; i < timed.settings.size(); ++i) {
    if (static_cast<int>(i) % request.shard.count != request.shard.index) continue;
    ++estimate.pictures;
    const PictureTime time = trial.time_of(timed.settings[i]);
    estimate.seconds +=
        time.prepare + compare + chart_point_seconds(time.of(trial.pixels()), request.repeats, request.shortest_sample);
    const Settings counted = counted_settings(timed.settings[i], traits);
    if (!(counted == timed.settings[i])) estimate.seconds += trial.seconds_of(counted);
  }
  return estimate;
}

NeedsEstimate estimate_needs(const NeedsRequest& request, StudyControl& control, const Clock& clock) {
  const SceneTraits traits = scene_traits(request.scene);
  Trial trial(request.scene, request.view, request.priority, control, clock);
  const double compare = trial.comparing(
      request.base, [](const MeasuredPicture& picture) { worst_tile_flip(picture.levels, picture.levels); });
  const double timed = trial.seconds_of(request.base);
  const Settings counted = counted_settings(request.base, traits);
  const double tried = compare + (counted == request.base ? timed : trial.seconds_of(counted));
  int used = 0;
  for (const Feature& feature : features()) used += unused_reason(feature, request.base, traits) ? 0 : 1;
  NeedsEstimate estimate;
  estimate.round.pictures = static_cast<int>(savings(request.base, traits).size());
  estimate.round.seconds = estimate.round.pictures * tried;
  estimate.least.pictures = 1 + used + estimate.round.pictures;
  const double reference = reference_seconds(needs_truth(request.base, traits, request.view).plan, trial);
  estimate.least.seconds = reference + estimate.least.pictures * tried + 2.0 * request.repeats * (2 + used) * timed;
  return estimate;
}

StudyEstimate estimate_model(const ModelRequest& request, StudyControl& control, const Clock& clock) {
  constexpr int rounds = 4;  // the full pictures, what they show, and steps that are tried
  const View& view = request.views.front();
  Trial trial(request.scene, view, request.priority, control, clock);
  StudyEstimate estimate;
  estimate.pictures = rounds * 2 * static_cast<int>(request.views.size());
  for (const auto& by : {model::HeldPictures::by_rays, model::HeldPictures::by_fragments})
    estimate.seconds += rounds * static_cast<double>(request.views.size()) * trial.seconds_of(by(request.base));
  return estimate;
}

std::string about_seconds(double seconds) {
  if (seconds < 1) return "under a second";
  if (seconds < 10) return fmt::format("about {:.0f} s", seconds);
  if (seconds < 95) return fmt::format("about {:.0f} s", 5 * std::round(seconds / 5));
  if (seconds < 5400) return fmt::format("about {:.0f} min", seconds / 60);
  return fmt::format("about {:.1f} h", seconds / 3600);
}

std::string at_least(double seconds) { return seconds < 1 ? "about a second" : "at least " + about_seconds(seconds); }

std::string estimate_text(const StudyEstimate& estimate) {
  return fmt::format("{}, {} picture{}", about_seconds(estimate.seconds), estimate.pictures,
                     estimate.pictures == 1 ? "" : "s");
}

}  // namespace ps
