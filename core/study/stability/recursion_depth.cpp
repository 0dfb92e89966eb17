#include <array>
#include <cmath>

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
    return picture_of(scene, {scene.camera, side, side}, settings, Channel::none, run).colour_double;
  };
  const Image<Vec3d> truth = picture(60);
  const auto rmse = [&](int depth) {
    const Image<Vec3d> shown = picture(depth);
    double sum = 0;
    for (std::size_t i = 0; i < truth.pixels().size(); ++i)
      for (int c = 0; c < 3; ++c) {
        const double d = std::min(shown.pixels()[i][c], 1.0) - std::min(truth.pixels()[i][c], 1.0);
        sum += d * d;
      }
    return 255 * std::sqrt(sum / (3.0 * static_cast<double>(truth.pixels().size())));
  };
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
