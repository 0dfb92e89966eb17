#include <array>

#include "image/metrics.h"
#include "image/mixing.h"
#include "options/scene_settings.h"
#include "render/render.h"
#include "scene/load.h"
#include "study/stability/support.h"

namespace ps::stability {

/// The book's reflections against the same picture with 60 bounces, in levels of 255 before rounding, clamped.
static std::vector<StabilityRow> measure_recursion_depth(const StabilityRun& run) {
  const Scene scene = load_scene("cgfs/reflections");
  Settings settings = settings_for(scene);
  settings.precision = Precision::float64;
  const int side = run.side(600);
  const auto picture = [&](int depth) {
    settings.reflection_depth = depth;
    auto colours = picture_of(scene, {scene.camera, side, side}, settings, Channel::none, run).colour_double;
    for (Vec3d& colour : colours.pixels()) colour = clamp_colour(colour);
    return colours;
  };
  const Image<Vec3d> truth = picture(60);
  const auto rmse = [&](int depth) { return 255 * compare_channels(picture(depth), truth).rmse; };
  constexpr int enough = 8;
  const double robust = rmse(enough);
  Rows rows(run);
  for (const int depth : {0, 1, 2, 3, 4, 5, 6, 8})
    rows.push_back({static_cast<double>(depth), "book scene", rmse(depth), robust, "RMSE, levels of 255"});
  return rows;
}

static StabilityPicture picture_recursion_depth(double depth) {
  StabilityPicture picture{.scene = "cgfs/reflections"};
  picture.naive.reflection_depth = static_cast<int>(depth);
  picture.robust.reflection_depth = 8;
  return picture;
}

static constexpr std::array frames{0.0, 1.0, 2.0, 3.0, 5.0};

const StabilityExperiment recursion_depth{.key = "recursion-depth",
                                          .title = "Recursion depth",
                                          .knob = "bounces",
                                          .naive = "stop after so many",
                                          .robust = "8 bounces",
                                          .explanation =
                                              "What is cut off weighs the product of the reflectivities along the "
                                              "path. Half-mirrors need 8 bounces to fall below half a level.",
                                          .safe = "From 3 bounces for this scene: 0.4 levels.",
                                          .window = {3, everywhere},
                                          .measure = measure_recursion_depth,
                                          .picture = picture_recursion_depth,
                                          .frames = frames};

}  // namespace ps::stability
