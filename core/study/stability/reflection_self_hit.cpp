#include "options/choice_key.h"
#include "render/render.h"
#include "scene/scene_file.h"
#include "study/stability/support.h"

namespace ps::stability::reflection_self_hit {
namespace {

/// The ground of the book's scene alone, in ambient light: a ground pixel is brighter than half of its colour only if
/// its mirrored ray meets the ground again, which a convex body never does.
constexpr const char* scene_text = R"(
viewport_size = 1 x 1
projection_plane_d = 1
background = black
sphere { center = (0, -5001, 0) radius = 5000 color = (255, 255, 0) reflective = 0.5 }
light { type = ambient intensity = 1 }
)";

double self_reflections(const Scene& scene, const Settings& settings, const StabilityRun& run) {
  const Frame frame = picture_of(scene, {scene.camera, 600, 600}, settings, Channel::ids, run);
  double seen = 0, wrong = 0;
  for (std::size_t i = 0; i < frame.ids.pixels().size(); ++i)
    if (frame.ids.pixels()[i].object == 0) {
      ++seen;
      wrong += frame.colour.pixels()[i].r > 0.6f ? 1 : 0;
    }
  return 100 * wrong / seen;
}

StabilityPicture picture_reflection_self_hit(double epsilon) {
  StabilityPicture picture;
  picture.scene = scene_text;
  picture.robust.reflection_depth = 1;
  picture.robust.sample_position = SamplePosition::corner;
  picture.naive = picture.robust;
  picture.naive.self_hit = SelfHit::epsilon;
  picture.naive.sphere_test = SphereTest::quadratic;
  picture.naive.reflection_epsilon = epsilon;
  return picture;
}

void measure_reflection_self_hit(const StabilityRun& run, Rows& rows) {
  const Scene scene = parse_scene(scene_text, "mirror ground", ".");
  for (const Precision precision : {Precision::float32, Precision::float64}) {
    Settings robust = picture_reflection_self_hit(0).robust;
    robust.precision = precision;
    const double robust_wrong = self_reflections(scene, robust, run);
    for (const double epsilon : {1e-4, 3e-4, 1e-3, 3e-3, 1e-2, 3e-2, 1e-1}) {
      Settings naive = picture_reflection_self_hit(epsilon).naive;
      naive.precision = precision;
      rows.add(epsilon, std::string(choice_key<&Settings::precision>(precision)), self_reflections(scene, naive, run),
               robust_wrong, "% of ground pixels that reflect the ground");
    }
  }
}

}  // namespace

extern const StabilityExperiment reflection_self_hit{
    .key = "reflection-self-hit",
    .place = {Subject::rays, 20},
    .set_up = SetUp::reproduction,
    .title = "Self-intersection: the ground reflects itself",
    .keywords = "acne, self-intersection, bias, epsilon, mirror",
    .knob = "reflection epsilon (ray parameter)",
    .naive = "ignore hits up to epsilon",
    .robust = "bounded offset, no epsilon",
    .explanation = "Towards the horizon reflected rays leave the ground almost along it and stay within its rounding "
                   "error for long. The book's 0.001 is enough in double and not in float.",
    .safe = "0.1 in float; 0.001 in double.",
    .window = {0.1, everywhere},
    .series = {{.names = "float|*", .title = "ground pixels that reflect the ground", .unit = "%"}},
    .add_rows = measure_reflection_self_hit,
    .picture = picture_reflection_self_hit,
    .frames = {1e-4, 1e-3, 1e-2, 1e-1}};

}  // namespace ps::stability::reflection_self_hit
