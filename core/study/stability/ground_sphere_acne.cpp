#include <array>

#include <fmt/format.h>

#include "render/render.h"
#include "scene/scene_file.h"
#include "study/stability/support.h"

namespace ps::stability {
namespace {

/// The book's camera and its ground sphere alone, touching y = -1, under one point light.
std::string ground_text(double radius, double light_y) {
  return fmt::format("viewport_size = 1 x 1\nprojection_plane_d = 1\n"
                     "sphere {{ center = (0, {}, 0) radius = {} color = (255, 255, 0) }}\n"
                     "light {{ type = point intensity = 1 position = (2, {}, 0) }}\n",
                     -1 - radius, radius, light_y);
}

Scene ground_under_light(double radius, double light_y) {
  return parse_scene(ground_text(radius, light_y), "ground", ".");
}

Settings with_epsilon(Settings settings, double epsilon) {
  settings.self_hit = SelfHit::epsilon;
  settings.sphere_test = SphereTest::quadratic;
  settings.shadow_epsilon = epsilon;
  return settings;
}

StabilityPicture picture_ground(double epsilon) {
  StabilityPicture picture{.scene = ground_text(5000, 1)};
  picture.naive = with_epsilon(picture.robust, epsilon);
  return picture;
}

Image<std::uint32_t> shadow_picture(const Scene& scene, const Settings& settings, const StabilityRun& run) {
  Frame frame = picture_of(scene, {scene.camera, 600, 600}, settings, Channel::shadow | Channel::ids, run);
  for (std::size_t i = 0; i < frame.shadow.pixels().size(); ++i)
    if (frame.ids.pixels()[i].object < 0) frame.shadow.pixels()[i] = 1;  // the sky is never lit
  return frame.shadow;
}

/// Percentage of truly lit pixels that the sphere shadows itself.
double false_shadow(const Image<std::uint32_t>& truth, const Image<std::uint32_t>& shadow) {
  double lit = 0, wrong = 0;
  for (std::size_t i = 0; i < truth.pixels().size(); ++i)
    if (truth.pixels()[i] == 0) {
      ++lit;
      wrong += shadow.pixels()[i] != 0 ? 1 : 0;
    }
  return lit > 0 ? 100 * wrong / lit : 0;
}

struct Series {
  std::string name;
  double radius, light_y;
  Precision precision;
};

constexpr std::array frames{0.0, 1e-5, 1e-4, 1e-3};

}  // namespace

static std::vector<StabilityRow> measure_ground_sphere_acne(const StabilityRun& run) {
  const std::vector<Series> all{{"radius 100, float", 100, 1, Precision::float32},
                                {"radius 1000, float", 1000, 1, Precision::float32},
                                {"radius 5000, float", 5000, 1, Precision::float32},
                                {"radius 5000, float, light 0.1 above", 5000, -0.9, Precision::float32},
                                {"radius 100000, float", 1e5, 1, Precision::float32},
                                {"radius 5000, double", 5000, 1, Precision::float64}};
  Rows rows(run);
  for (const Series& series : all) {
    run.check();
    const Scene scene = ground_under_light(series.radius, series.light_y);
    Settings robust;
    robust.precision = Precision::float64;
    const auto truth = shadow_picture(scene, robust, run);
    robust.precision = series.precision;
    const double robust_wrong = false_shadow(truth, shadow_picture(scene, robust, run));
    for (const double epsilon : {0.0, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2}) {
      rows.push_back({epsilon, series.name,
                      false_shadow(truth, shadow_picture(scene, with_epsilon(robust, epsilon), run)), robust_wrong,
                      "% of lit pixels in their own shadow"});
    }
  }
  return rows;
}

const StabilityExperiment ground_sphere_acne{
    .key = "ground-sphere-acne",
    .title = "Ground-sphere acne",
    .knob = "shadow epsilon (ray parameter)",
    .naive = "ignore hits up to epsilon",
    .robust = "bounded offset, no epsilon",
    .explanation =
        "At radius 5000 the squared distance to the centre lies on a grid of 2, so hit points sit up to 0.00018 off "
        "the sphere. A shadow ray that starts below the surface meets it again, later the lower the light stands.",
    .safe = "No epsilon is safe for every radius and light; 0.001 serves the book's scene.",
    .window = nowhere_safe,
    .measure = measure_ground_sphere_acne,
    .picture = picture_ground,
    .frames = frames};

}  // namespace ps::stability
