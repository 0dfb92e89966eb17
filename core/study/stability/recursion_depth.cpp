#include <algorithm>

#include <fmt/format.h>
#include <glm/common.hpp>

#include "base/counters.h"
#include "image/metrics.h"
#include "image/mixing.h"
#include "options/scene_settings.h"
#include "render/render.h"
#include "scene/load.h"
#include "study/stability/support.h"

namespace ps::stability::recursion_depth {

namespace {

/// A scene of mirrors up to some recursion depth, traced through the corners of side x side pixels as in the book.
/// Colours in double, clamped.
class Mirrors {
 public:
  Mirrors(Scene scene, int side, const StabilityRun& run) : scene_(std::move(scene)), side_(side), run_(run) {
    settings_ = settings_for(scene_);
    settings_.precision = Precision::float64;
    settings_.sample_position = SamplePosition::corner;
    truth_ = picture(60).colours;
  }

  struct Picture {
    Image<Vec3d> colours;
    double rays = 0;  ///< eye and reflection rays per pixel
  };
  Picture picture(int depth) {
    settings_.reflection_depth = depth;
    Frame frame = picture_of(scene_, {scene_.camera, side_, side_}, settings_, Channel::none, run_);
    const auto rays = static_cast<double>(frame.counters[Counter::eye_rays] + frame.counters[Counter::reflection_rays]);
    Picture result{std::move(frame.colour_double), rays / (side_ * side_)};
    for (Vec3d& colour : result.colours.pixels()) colour = clamp_colour(colour);
    return result;
  }

  struct Error {
    double rmse = 0, largest = 0;  ///< levels, of single channels
    double off = 0;                ///< percentage of pixels with a channel off by more than half a level
    double rays = 0;
  };
  Error error(int depth) {
    const Picture of = picture(depth);
    const Comparison all = compare_channels(of.colours, truth_);
    double off = 0;
    for (std::size_t i = 0; i < truth_.pixels().size(); ++i) {
      const Vec3d d = glm::abs(of.colours.pixels()[i] - truth_.pixels()[i]);
      off += std::max({d.x, d.y, d.z}) > 0.5 / 255 ? 1 : 0;
    }
    return {255 * all.rmse, 255 * all.max, percent(off, side_ * side_), of.rays};
  }

 private:
  Scene scene_;
  Settings settings_;
  int side_;
  const StabilityRun& run_;
  Image<Vec3d> truth_;  ///< at depth 60
};

/// The book's scene with one reflectivity for all of its objects.
Scene all_mirrors(double reflective) {
  Scene scene = load_scene("cgfs/reflections");
  std::vector<Material> materials = *scene.materials;
  for (Material& material : materials) material.reflective = reflective;
  scene.materials = Part<std::vector<Material>>(std::move(materials));
  return scene;
}

}  // namespace

/// The book's reflections against the same picture at depth 60, in levels of 255 before rounding, clamped.
static void measure_recursion_depth(const StabilityRun& run, Rows& rows) {
  constexpr int enough = 8;
  const std::string levels = "RMSE, levels of 255";
  Mirrors book(load_scene("cgfs/reflections"), run.side(600, 200), run);
  const Mirrors::Error robust = book.error(enough);
  for (const int depth : {0, 1, 2, 3, 4, 5, 6, 8}) {
    const Mirrors::Error naive = depth == enough ? robust : book.error(depth);
    const double knob = depth;
    rows.add(knob, "book scene", naive.rmse, robust.rmse, levels);
    rows.add(knob, "book scene, largest difference", naive.largest, robust.largest, "levels of 255");
    rows.add(knob, "book scene, pixels off by half a level", naive.off, robust.off, "% of pixels");
    rows.add(knob, "book scene, rays", naive.rays, robust.rays, "rays per pixel");
  }
  for (const double reflective : {0.9, 0.99}) {
    Mirrors mirrors(all_mirrors(reflective), 200, run);
    const double most = mirrors.error(20).rmse;
    for (const int depth : {3, 8, 20})
      rows.add(depth, fmt::format("every reflectivity {}", reflective), depth == 20 ? most : mirrors.error(depth).rmse,
               most, levels);
  }
}

static StabilityPicture picture_recursion_depth(double depth) {
  StabilityPicture picture{.scene = "cgfs/reflections"};
  picture.naive.reflection_depth = static_cast<int>(depth);
  picture.robust.reflection_depth = 8;
  return picture;
}

extern const StabilityExperiment recursion_depth{
    .key = "recursion-depth",
    .place = {Subject::numbers, 30},
    .set_up = SetUp::reproduction,
    .title = "Recursion depth",
    .keywords = "mirror, reflection, recursion limit, bounces",
    .knob = "depth (reflections in a row)",
    .naive = "a small depth",
    .robust = "depth 8",
    .explanation = "The error of a limit is weighted by the product of the reflectivities along the path. At a "
                   "reflectivity of 0.5 it falls below half a level at depth 8.",
    .safe = "From a depth of 3 for this scene: an error of 0.4 levels (RMS).",
    .window = {3, everywhere},
    .series = {{.names = "book scene|*",
                .title = "error of the picture (RMSE)",
                .unit = "levels of 255",
                .between = Between::nothing},
               {.names = "*largest difference",
                .title = "largest error of a pixel",
                .unit = "levels of 255",
                .between = Between::nothing},
               {.names = "*pixels off by half a level",
                .title = "pixels off by half a level",
                .unit = "%",
                .between = Between::nothing},
               {.names = "*rays", .title = "rays for each pixel", .unit = "rays", .between = Between::nothing}},
    .add_rows = measure_recursion_depth,
    .picture = picture_recursion_depth,
    .frames = {0.0, 1.0, 2.0, 3.0, 5.0}};

}  // namespace ps::stability::recursion_depth
