#include "study/model/held_pictures.h"

#include <algorithm>
#include <cmath>

#include "frame/display_frame.h"
#include "image/metrics.h"
#include "options/renderer_kind.h"
#include "study/counted_work.h"
#include "study/reference.h"
#include "study/study_frame.h"
#include "study/view_pixels.h"
#include "study/worst_tile.h"

namespace ps::model {
namespace {

constexpr int small_part = 4, least_small = 32;  ///< of the sides
constexpr int mean_samples = 16;                 ///< of each of the two patterns of a reference

/// The mean over each pixel of the scene, by rays.
Image<Rgb8> mean_picture(const Scene& scene, const View& view, const Settings& settings, StudyControl& control,
                         WorkerPriority priority) {
  std::vector<SweepPoint> points(2);
  points[0].value = points[1].value = settings;
  points[1].value.texture_filter =
      settings.texture_filter == TextureFilter::nearest ? TextureFilter::bilinear : TextureFilter::nearest;
  const ReferencePlan plan = plan_reference(points, settings, scene_traits(scene), view, {{}, mean_samples});
  return make_reference(scene, view, plan, {}, {ErrorMetric::flip, {}, {}}, priority, control.progress())
      .picture.levels;
}

}  // namespace

Settings HeldPictures::by_rays(Settings settings) {
  if (!sends_rays(settings.renderer)) settings.renderer = renderer_for(PictureWay::rays);
  return settings;
}

Settings HeldPictures::by_fragments(Settings settings) {
  settings.renderer = renderer_for(PictureWay::fragments);
  return settings;
}

HeldPictures::HeldPictures(const Scene& full, std::vector<View> views, const Settings& settings, StudyControl& control,
                           WorkerPriority priority)
    : full_(full), views_(std::move(views)), settings_(settings), control_(control), priority_(priority) {
  small_views_ = views_;
  for (View& view : small_views_) {
    view.width = std::max(view.width / small_part, std::min(view.width, least_small));
    view.height = std::max(view.height / small_part, std::min(view.height, least_small));
  }
  held_ = hold(views_);
}

std::vector<HeldPictures::Held> HeldPictures::hold(const std::vector<View>& views) const {
  Prepared prepared;
  std::vector<Held> all;
  for (const View& view : views)
    for (const bool rays : {true, false}) {
      Held& held = all.emplace_back();
      held.view = view;
      held.rays = rays;
      held.levels = levels_of(full_, held, settings_, prepared);
    }
  return all;
}

Frame HeldPictures::frame_of(const Scene& scene, const View& view, const Settings& settings, Prepared& prepared,
                             Channel channels) const {
  ++rendered_;
  return study_frame(scene, view, settings, control_, priority_, prepared, channels);
}

Image<Rgb8> HeldPictures::levels_of(const Scene& scene, const Held& held, const Settings& settings,
                                    Prepared& prepared) const {
  const Settings drawn = held.rays ? by_rays(settings) : by_fragments(settings);
  return display_frame(frame_of(scene, held.view, drawn, prepared), drawn);
}

void HeldPictures::allow_means() {
  for (Held& held : held_) {
    if (!held.rays || held.mean) continue;
    control_.wait_here();
    held.mean = mean_picture(full_, held.view, by_rays(settings_), control_, priority_);
    held.from_mean = tile_flips(*held.mean, held.levels);
  }
}

Change HeldPictures::change_of(const std::vector<Held>& held, const Scene& scene, const Settings& settings,
                               double enough) const {
  Prepared prepared;
  Change all;
  for (const Held& one : held) {
    const Image<Rgb8> levels = levels_of(scene, one, settings, prepared);
    if (levels == one.levels) continue;
    std::vector<double> tiles = tile_flips(one.levels, levels);
    if (one.mean && *std::max_element(tiles.begin(), tiles.end()) > 0) {
      const std::vector<double> from_mean = tile_flips(*one.mean, levels);
      for (std::size_t i = 0; i < tiles.size(); ++i)
        tiles[i] = std::min(tiles[i], std::max(0.0, from_mean[i] - one.from_mean[i]));
    }
    all.increase = std::max(all.increase, *std::max_element(tiles.begin(), tiles.end()));
    all.rmse = std::max(all.rmse, compare_channels(one.levels, levels).rmse);
    if (all.increase > enough) break;
  }
  return all;
}

Change HeldPictures::change(const Scene& scene, const Settings& settings, double enough) {
  return change_of(held_, scene, settings, enough);
}

std::uint64_t HeldPictures::work(const Scene& scene, const Settings& settings) const {
  const Settings asked = draws_fragments(settings.renderer) ? by_fragments(settings) : by_rays(settings);
  const Settings counted = counted_settings(asked, scene_traits(scene));
  Prepared prepared;
  std::uint64_t work = 0;
  for (const View& view : small_views_)
    work += counted_work(frame_of(scene, view, counted, prepared).counters).value_or(0);
  return work;
}

double HeldPictures::wrong_in_float(const Scene& scene, Settings settings) const {
  settings.precision = Precision::float32;
  Prepared prepared;
  double most = 0;
  for (const View& view : small_views_)
    for (const auto& by : {by_rays, by_fragments}) {
      const Frame frame = frame_of(scene, view, by(settings), prepared, Channel::ids | Channel::precision);
      const auto wrong =
          std::count_if(frame.precision.pixels().begin(), frame.precision.pixels().end(), [](PrecisionFault fault) {
            return fault != PrecisionFault::none && fault != PrecisionFault::shading;
          });
      most = std::max(most, static_cast<double>(wrong) / pixels_of(view));
    }
  return most;
}

double HeldPictures::smallest_depth_gap(const Scene& scene, const Settings& settings) const {
  Prepared prepared;
  double smallest = INFINITY;
  for (const View& view : small_views_) {
    const Frame frame = frame_of(scene, view, by_fragments(settings), prepared, Channel::ids | Channel::depth_gap);
    for (const float gap : frame.depth_gap.pixels()) smallest = std::min(smallest, static_cast<double>(gap));
  }
  return smallest;
}

Change HeldPictures::small_change(const Scene& scene, const Settings& settings) {
  if (held_small_.empty()) held_small_ = hold(small_views_);
  return change_of(held_small_, scene, settings, 1);
}

}  // namespace ps::model
