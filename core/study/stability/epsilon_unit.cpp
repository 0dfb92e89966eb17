#include <fmt/format.h>

#include "scene/scene_file.h"
#include "study/stability/support.h"

namespace ps::stability::epsilon_unit {
namespace {

constexpr double epsilon = 1e-3;

/// A wall under a light whose direction has a length, and a small board `height` before the wall along that direction.
std::string board_before_wall(double length, double height) {
  const double x = 0.6, z = -0.8;
  return fmt::format("viewport_size = 1 x 1\nprojection_plane_d = 1\n"
                     "rectangle {{ corner = (-2, -2, 3) side_a = (4, 0, 0) side_b = (0, 4, 0) color = white }}\n"
                     "rectangle {{ corner = ({}, {}, {}) side_a = ({}, 0, 0) side_b = (0, {}, 0) color = red }}\n"
                     "light {{ type = directional intensity = 1 direction = ({}, 0, {}) }}\n",
                     0.5 * x * height, -0.5 * height, 3 + z * height, x * height, height, x * length, z * length);
}

/// How near to the wall a board may come before its shadow is lost: half-way search over rendered pixels.
double shortest_shadow(double length, EpsilonUnit unit, const StabilityRun& run) {
  Settings settings;
  settings.precision = Precision::float64;
  settings.self_hit = SelfHit::epsilon;
  settings.shadow_epsilon = epsilon;
  settings.epsilon_unit = unit;
  double lost = 1e-5, seen = 0.5;
  for (int i = 0; i < 30; ++i) {
    const double middle = std::sqrt(lost * seen);
    const Scene scene = parse_scene(board_before_wall(length, middle), "board", ".");
    const Frame frame = picture_of(scene, {scene.camera, 1, 1}, settings, Channel::shadow, run);
    (frame.shadow.at(0, 0) != 0 ? seen : lost) = middle;
  }
  return seen;
}

void measure(const StabilityRun& run, Rows& rows) {
  for (const double length : {0.1, 1.0, 3.5, 5.744562646538029, 100.0})
    rows.add(length, "shadow rays", shortest_shadow(length, EpsilonUnit::ray_parameter, run),
             shortest_shadow(length, EpsilonUnit::distance, run), "units between board and wall");
}

}  // namespace

extern const StabilityExperiment epsilon_unit{
    .key = "epsilon-unit",
    .place = {Subject::rays, 40},
    .set_up = SetUp::reproduction,
    .title = "Epsilon in t is not a distance",
    .keywords = "bias, scale, ray parameter, acne",
    .knob = "length of the light's direction",
    .naive = "t > 0.001",
    .robust = "distance > 0.001",
    .explanation = "t counts lengths of the direction, so an epsilon in t is as many times longer. The book's 0.001 is "
                   "0.0035 units towards its point light and 0.0057 towards its directional one.",
    .safe = "Directions of length 1.",
    .window = {1, 1},
    .series = {{.names = "*", .title = "gap between board and wall that is skipped", .unit = "world units"}},
    .add_rows = measure};

}  // namespace ps::stability::epsilon_unit
