#include "scene/scene_file.h"
#include "study/stability/support.h"

namespace ps::stability::epsilon_too_large {
namespace {

constexpr int point_light = 1, sun = 2;

/// The book's red ball, sunk into its ground to its centre, and the two lights: what is lost is the shadow that begins
/// where the two touch.
constexpr const char* scene_text = R"(
viewport_size = 1 x 1
projection_plane_d = 1
background = black
sphere { center = (0, -5001, 0) radius = 5000 color = (255, 255, 0) }
sphere { center = (0, -1, 3) radius = 1 color = (255, 0, 0) }
light { type = ambient intensity = 0.2 }
light { type = point intensity = 0.6 position = (2, 1, 0) }
light { type = directional intensity = 0.2 direction = (1, 4, 4) }
)";
constexpr int ground = 0;

Settings guarded(double epsilon) {
  Settings settings;
  settings.precision = Precision::float64;
  settings.sample_position = SamplePosition::corner;
  settings.reflection_depth = 0;
  if (epsilon >= 0) {
    settings.self_hit = SelfHit::epsilon;
    settings.shadow_epsilon = epsilon;
  }
  return settings;
}

Frame shadows_of(const Scene& scene, const Settings& settings, const StabilityRun& run) {
  const int side = run.side(600, 300);
  return picture_of(scene, {scene.camera, side, side}, settings, Channel::shadow | Channel::ids, run);
}

/// Percentage of the ground in the light's shadow that is lit.
double lost(const Frame& truth, const Frame& frame, int light) {
  double all = 0, gone = 0;
  for (std::size_t i = 0; i < truth.ids.pixels().size(); ++i) {
    if (truth.ids.pixels()[i].object != ground || (truth.shadow.pixels()[i] >> light & 1) == 0) continue;
    ++all;
    gone += (frame.shadow.pixels()[i] >> light & 1) == 0 ? 1 : 0;
  }
  return percent(gone, all);
}

void measure(const StabilityRun& run, Rows& rows) {
  const Scene scene = parse_scene(scene_text, "ball", ".");
  const Frame truth = shadows_of(scene, guarded(-1), run);
  Settings robust = guarded(-1);
  robust.precision = Precision::float32;
  const Frame offset = shadows_of(scene, robust, run);
  for (const double epsilon : {1e-3, 1e-2, 0.05, 0.1, 0.2, 0.3, 0.5}) {
    const Frame frame = shadows_of(scene, guarded(epsilon), run);
    for (const int light : {point_light, sun})
      rows.add(epsilon, light == sun ? "directional light" : "point light", lost(truth, frame, light),
               lost(truth, offset, light), "% of the shadow on the ground lost");
  }
}

StabilityPicture picture(double epsilon) {
  StabilityPicture picture{.scene = scene_text};
  picture.naive.self_hit = SelfHit::epsilon;
  picture.naive.shadow_epsilon = epsilon;
  return picture;
}

}  // namespace

extern const StabilityExperiment epsilon_too_large{
    .key = "epsilon-too-large",
    .place = {Subject::rays, 30},
    .title = "Epsilon too large",
    .keywords = "bias, light leak, shadow, self-intersection",
    .knob = "shadow epsilon (ray parameter)",
    .naive = "ignore hits up to epsilon",
    .robust = "bounded offset, no epsilon",
    .explanation = "An epsilon skips everything nearer, also the object whose shadow begins there. Towards the "
                   "directional light (1, 4, 4) it skips nearly six times its value.",
    .safe = "Up to 0.01 for this scene.",
    .window = {nowhere, 0.01},
    .series = {{.names = "directional light|point light", .title = "shadow on the ground that is lost", .unit = "%"}},
    .add_rows = measure,
    .picture = picture,
    .frames = {1e-3, 0.1, 0.2, 0.3, 0.5}};

}  // namespace ps::stability::epsilon_too_large
