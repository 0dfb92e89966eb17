#include "render/render.h"
#include "scene/scene_file.h"
#include "study/stability/experiments.h"

namespace ps::stability {
namespace {

/// The book's four spheres in ambient light alone, all black but the ground: a ground pixel is brighter than half of
/// its colour only if its mirrored ray meets the ground again.
constexpr const char* scene_text = R"(
viewport_size = 1 x 1
projection_plane_d = 1
background = black
sphere { center = (0, -1, 3) radius = 1 color = (0, 0, 0) }
sphere { center = (-2, 0, 4) radius = 1 color = (0, 0, 0) }
sphere { center = (2, 0, 4) radius = 1 color = (0, 0, 0) }
sphere { center = (0, -5001, 0) radius = 5000 color = (255, 255, 0) reflective = 0.5 }
light { type = ambient intensity = 1 }
)";
constexpr int ground = 3;

double self_reflections(const Scene& scene, const Settings& settings, const StabilityRun& run) {
  Prepared prepared;
  Progress own;
  RenderRequest request;
  request.channels = Channel::ids;
  const Frame frame =
      render(scene, {scene.camera, 600, 600}, settings, request, prepared, run.progress ? *run.progress : own);
  double seen = 0, wrong = 0;
  for (std::size_t i = 0; i < frame.ids.pixels().size(); ++i)
    if (frame.ids.pixels()[i].object == ground) {
      ++seen;
      wrong += frame.colour.pixels()[i].r > 0.6f ? 1 : 0;
    }
  return 100 * wrong / seen;
}

}  // namespace

std::vector<StabilityRow> reflection_self_hit(const StabilityRun& run) {
  const Scene scene = parse_scene(scene_text, "mirror ground", ".");
  std::vector<StabilityRow> rows;
  for (const Precision precision : {Precision::float32, Precision::float64}) {
    Settings robust;
    robust.precision = precision;
    robust.reflection_depth = 1;
    robust.sample_position = SamplePosition::corner;
    const double robust_wrong = self_reflections(scene, robust, run);
    Settings naive = robust;
    naive.self_hit = SelfHit::epsilon;
    naive.sphere_test = SphereTest::quadratic;
    for (const double epsilon : {1e-4, 3e-4, 1e-3, 3e-3, 1e-2, 3e-2, 1e-1}) {
      run.check();
      naive.reflection_epsilon = epsilon;
      rows.push_back({epsilon, precision == Precision::float32 ? "float" : "double",
                      self_reflections(scene, naive, run), robust_wrong, "% of ground pixels that mirror the ground"});
    }
  }
  return rows;
}

}  // namespace ps::stability
