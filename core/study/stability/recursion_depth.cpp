#include "options/scene_settings.h"
#include "render/display_frame.h"
#include "render/render.h"
#include "scene/load.h"
#include "study/stability/experiments.h"

#include <cmath>

namespace ps::stability {

/// The book's reflections against the same picture with 60 bounces, in levels of 255 before rounding, clamped.
std::vector<StabilityRow> recursion_depth(const StabilityRun& run) {
  const Scene scene = load_scene("cgfs/reflections");
  Settings settings = settings_for(scene);
  settings.precision = Precision::float64;
  const auto picture = [&](int depth) {
    settings.reflection_depth = depth;
    Prepared prepared;
    Progress own;
    return render(scene, {scene.camera, 600, 600}, settings, {}, prepared, run.progress ? *run.progress : own)
        .colour_double;
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
  std::vector<StabilityRow> rows;
  for (const int depth : {0, 1, 2, 3, 4, 5, 6, 8})
    rows.push_back({static_cast<double>(depth), "book scene", rmse(depth), robust, "RMSE, levels of 255"});
  return rows;
}

}  // namespace ps::stability
