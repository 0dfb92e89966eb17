#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "render/render.h"
#include "scene/scene_file.h"
#include "study/stability/ground_sphere_points.h"
#include "study/stability/support.h"

namespace ps::stability::ground_sphere_acne {
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

struct Series {
  std::string name;
  double radius;
  Vec3d centre;
  double light_y;
  Precision precision;
  std::vector<double> epsilons;
  int side = 600;  ///< of the picture, px: the book's, or more where few pixels fail
  /// Where the light grazes the ball, rounding decides whether it is above the horizon: pixels that are not lit by
  /// a light so much lower do not count.
  double grazing = 0;
};

/// Which pixels show the ball in the light, and which show it in its own shadow.
enum class Seen : std::uint8_t { sky, lit, shadowed };

Image<Seen> ball_picture(const Series& series, double light_y, const Settings& settings, const StabilityRun& run) {
  const Scene scene = parse_scene(ground_text(series.radius, light_y, series.centre), "ground", ".");
  const View view{scene.camera, series.side, series.side};
  const Frame frame = picture_of(scene, view, settings, Channel::shadow | Channel::ids, run);
  Image<Seen> seen(series.side, series.side, Seen::sky);
  for (std::size_t i = 0; i < seen.pixels().size(); ++i)
    if (frame.ids.pixels()[i].object >= 0)
      seen.pixels()[i] = frame.shadow.pixels()[i] == 0 ? Seen::lit : Seen::shadowed;
  return seen;
}

/// What double sees.
Image<Seen> truth_picture(const Series& series, Settings settings, const StabilityRun& run) {
  settings.precision = Precision::float64;
  Image<Seen> truth = ball_picture(series, series.light_y, settings, run);
  if (series.grazing == 0) return truth;
  const Image<Seen> lower = ball_picture(series, series.light_y - series.grazing, settings, run);
  for (std::size_t i = 0; i < truth.pixels().size(); ++i)
    if (lower.pixels()[i] == Seen::shadowed) truth.pixels()[i] = Seen::shadowed;
  return truth;
}

/// Percentage of truly lit pixels that the ball shadows itself. At its outline a ray may miss the ball that a more
/// exact one meets, which is not a matter of shadows.
double false_shadow(const Image<Seen>& truth, const Image<Seen>& shown) {
  double lit = 0, wrong = 0;
  for (std::size_t i = 0; i < truth.pixels().size(); ++i) {
    if (truth.pixels()[i] != Seen::lit || shown.pixels()[i] == Seen::sky) continue;
    ++lit;
    wrong += shown.pixels()[i] == Seen::shadowed ? 1 : 0;
  }
  return percent(wrong, lit);
}

/// How far hit points lie off the ground; the knob is 0, since no epsilon changes that.
void add_points(Rows& rows, const StabilityRun& run) {
  for (const double radius : {5000.0, 1e6}) {
    const auto add = [&](const char* how, SphereForm form, Precision precision, ErrorIn error_in) {
      const OffSurface off = hit_off_surface(radius, form, precision, error_in, run);
      const std::string series = fmt::format("hit point, radius {:.0f}, {}", radius, how);
      rows.add(0, series, off.rms, std::nan(""), "off the surface (rms)");
      rows.add(0, series + ", largest", off.largest, std::nan(""), "off the surface (largest)");
    };
    add("float", SphereForm::textbook, Precision::float32, ErrorIn::long_double);
    add("float, remainder vector", SphereForm::remainder, Precision::float32, ErrorIn::long_double);
    add("double", SphereForm::textbook, Precision::float64, ErrorIn::long_double);
    add("double, error evaluated in double", SphereForm::textbook, Precision::float64, ErrorIn::same);
  }
}

}  // namespace

static void measure_ground_sphere_acne(const StabilityRun& run, Rows& rows) {
  const std::vector<double> book{0.0, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2}, coarse{1e-4, 1e-3, 1e-2};
  const std::vector<double> book_but_rare{0.0, 1e-6, 1e-5, 1e-3, 1e-2};
  const std::vector<double> fine{0.0, 1e-12, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2};
  constexpr Precision single = Precision::float32;
  const std::vector<Series> all{
      {"radius 1, float", 1, {0, -1, 3}, 1, single, book_but_rare},
      {"radius 1, float", 1, {0, -1, 3}, 1, single, {1e-4}, 1200},
      {"radius 100, float", 100, below(100), 1, single, book},
      {"radius 1000, float", 1000, below(1000), 1, single, book},
      {"radius 5000, float", 5000, below(5000), 1, single, book},
      {"radius 5000, float, light 0.5 above", 5000, below(5000), -0.5, single, coarse},
      {"radius 5000, float, light 0.1 above", 5000, below(5000), -0.9, single, book},
      {"radius 5000, float, light 0.02 above", 5000, below(5000), -0.98, single, coarse, 600, 1e-5},
      {"radius 5000, float, light 0.02 above, grazing pixels as well", 5000, below(5000), -0.98, single, {1e-3}},
      {"radius 100000, float", 1e5, below(1e5), 1, single, book},
      {"radius 5000, double", 5000, below(5000), 1, Precision::float64, fine}};
  for (const Series& series : all) {
    run.check();
    Settings robust;
    robust.sample_position = SamplePosition::corner;  // the book's rays
    robust.precision = series.precision;
    const Image<Seen> truth = truth_picture(series, robust, run);
    const double robust_wrong = false_shadow(truth, ball_picture(series, series.light_y, robust, run));
    for (const double epsilon : series.epsilons) {
      rows.add(epsilon, series.name,
               false_shadow(truth, ball_picture(series, series.light_y, with_epsilon(robust, epsilon), run)),
               robust_wrong, "% of lit pixels in their own shadow");
    }
  }
  for (const double epsilon : coarse)
    rows.add(epsilon, "radius 5000, float, remainder vector alone",
             false_shadow_by_remainder(static_cast<float>(epsilon), run), std::nan(""),
             "% of lit pixels in their own shadow");
  add_points(rows, run);
}

extern const StabilityExperiment ground_sphere_acne{
    .key = "ground-sphere-acne",
    .place = {Subject::rays, 10},
    .set_up = SetUp::reproduction,
    .title = "Shadow acne: a ground sphere shadows itself",
    .keywords = "shadow acne, self-intersection, bias, epsilon, large sphere",
    .knob = "shadow epsilon (ray parameter)",
    .naive = "ignore hits up to epsilon (self-hit = epsilon)",
    .robust = "start outside the error bound of the hit point (self-hit = offset)",
    .explanation =
        "At radius 5000 the squared distance to the centre is rounded to multiples of 2, so hit points lie up to "
        "0.00018 off the sphere. A shadow ray that starts below the surface meets it again, at a larger t the lower "
        "the light is.",
    .safe = "No epsilon is safe for every radius and light; 0.001 is enough for the book's scene.",
    .window = nowhere_safe,
    .series = {{.names = "radius 5000, float|radius*", .title = "lit pixels in their own shadow", .unit = "%"},
               {.names = "hit point*",
                .title = "distance of hit points from the sphere (RMS)",
                .unit = "world units",
                .naive = "hit point",
                .robust = "none"},
               {.names = "hit point*largest",
                .title = "largest distance of a hit point from the sphere",
                .unit = "world units",
                .naive = "hit point",
                .robust = "none"}},
    .add_rows = measure_ground_sphere_acne,
    .picture = picture_ground,
    .frames = {0.0, 1e-5, 1e-4, 1e-3}};

}  // namespace ps::stability::ground_sphere_acne
