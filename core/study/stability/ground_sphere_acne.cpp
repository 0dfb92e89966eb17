#include <array>

#include <fmt/format.h>

#include "render/render.h"
#include "scene/scene_file.h"
#include "study/stability/ground_sphere_points.h"
#include "study/stability/support.h"

namespace ps::stability {
namespace {

/// The book's camera and its ground sphere alone, touching y = -1, under one point light.
std::string ground_text(double radius, double light_y, const Vec3d& centre) {
  return fmt::format("viewport_size = 1 x 1\nprojection_plane_d = 1\n"
                     "sphere {{ center = ({}, {}, {}) radius = {} color = (255, 255, 0) }}\n"
                     "light {{ type = point intensity = 1 position = (2, {}, 0) }}\n",
                     centre.x, centre.y, centre.z, radius, light_y);
}
Vec3d below(double radius) { return {0, -1 - radius, 0}; }

Settings with_epsilon(Settings settings, double epsilon) {
  settings.self_hit = SelfHit::epsilon;
  settings.sphere_test = SphereTest::quadratic;
  settings.shadow_epsilon = epsilon;
  return settings;
}

StabilityPicture picture_ground(double epsilon) {
  StabilityPicture picture{.scene = ground_text(5000, 1, below(5000))};
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
  double radius;
  Vec3d centre;
  double light_y;
  Precision precision;
  std::vector<double> epsilons;
  SamplePosition at = SamplePosition::centre;  ///< the book's corner where few pixels tell
};

/// What needs no picture: how far the points lie off the ground, at a knob of 0 since no epsilon changes that, and what
/// the better discriminant does to the shadow where the point stays as it is found.
void add_points(Rows& rows, const StabilityRun& run) {
  for (const double radius : {5000.0, 1e6}) {
    const auto add = [&](const char* how, SphereForm form, Precision precision, ToldIn told_in) {
      const OffSurface off = hit_off_surface(radius, form, precision, told_in, run);
      const std::string series = fmt::format("hit point, radius {:.0f}, {}", radius, how);
      rows.push_back({0, series, off.rms, std::nan(""), "off the surface (rms)"});
      rows.push_back({0, series + ", largest", off.largest, std::nan(""), "off the surface (largest)"});
    };
    add("float", SphereForm::textbook, Precision::float32, ToldIn::long_double);
    add("float, remainder vector", SphereForm::remainder, Precision::float32, ToldIn::long_double);
    add("double", SphereForm::textbook, Precision::float64, ToldIn::long_double);
    add("double, told in double", SphereForm::textbook, Precision::float64, ToldIn::same);
  }
}

constexpr std::array frames{0.0, 1e-5, 1e-4, 1e-3};

}  // namespace

static std::vector<StabilityRow> measure_ground_sphere_acne(const StabilityRun& run) {
  const std::vector<double> book{0.0, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2}, coarse{1e-4, 1e-3, 1e-2};
  const std::vector<double> fine{0.0, 1e-12, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2};
  constexpr Precision single = Precision::float32;
  const std::vector<Series> all{
      {"radius 1, float", 1, {0, -1, 3}, 1, single, book, SamplePosition::corner},
      {"radius 100, float", 100, below(100), 1, single, book},
      {"radius 1000, float", 1000, below(1000), 1, single, book},
      {"radius 5000, float", 5000, below(5000), 1, single, book},
      {"radius 5000, float, light 0.5 above", 5000, below(5000), -0.5, single, coarse, SamplePosition::corner},
      {"radius 5000, float, light 0.1 above", 5000, below(5000), -0.9, single, book},
      {"radius 5000, float, light 0.02 above", 5000, below(5000), -0.98, single, coarse},
      {"radius 100000, float", 1e5, below(1e5), 1, single, book},
      {"radius 5000, double", 5000, below(5000), 1, Precision::float64, fine}};
  Rows rows(run);
  for (const Series& series : all) {
    run.check();
    const Scene scene = parse_scene(ground_text(series.radius, series.light_y, series.centre), "ground", ".");
    Settings robust;
    robust.sample_position = series.at;
    robust.precision = Precision::float64;
    const auto truth = shadow_picture(scene, robust, run);
    robust.precision = series.precision;
    const double robust_wrong = false_shadow(truth, shadow_picture(scene, robust, run));
    for (const double epsilon : series.epsilons) {
      rows.push_back({epsilon, series.name,
                      false_shadow(truth, shadow_picture(scene, with_epsilon(robust, epsilon), run)), robust_wrong,
                      "% of lit pixels in their own shadow"});
    }
  }
  for (const double epsilon : coarse)
    rows.push_back({epsilon, "radius 5000, float, remainder vector alone",
                    false_shadow_by_remainder(static_cast<float>(epsilon), run), std::nan(""),
                    "% of lit pixels in their own shadow"});
  add_points(rows, run);
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
