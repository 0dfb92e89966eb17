#include <algorithm>

#include <fmt/format.h>

#include "scene/scene_file.h"
#include "study/stability/support.h"

namespace ps::stability::world_offset_sphere_acne {
namespace {

/// The book's red ball under one point light, the whole world with its camera moved by `distance` along all three axes.
std::string world_text(double distance) {
  const double w = distance;
  return fmt::format("viewport_size = 1 x 1\nprojection_plane_d = 1\ncamera {{ position = ({}, {}, {}) }}\n"
                     "sphere {{ center = ({}, {}, {}) radius = 1 color = (220, 180, 60) }}\n"
                     "light {{ type = ambient intensity = 0.2 }}\n"
                     "light {{ type = point intensity = 0.8 position = ({}, {}, {}) }}\n",
                     w, w, w, w, w - 1, w + 3, w + 2, w + 1, w);
}

/// In the coordinates of the world: near an origin of the scene's own there is nothing to see.
Settings in_the_world() {
  Settings settings;
  settings.camera_relative = false;
  return settings;
}

Settings with_epsilon(double epsilon) {
  Settings settings = in_the_world();
  settings.self_hit = SelfHit::epsilon;
  settings.sphere_test = SphereTest::quadratic;
  settings.shadow_epsilon = epsilon;
  return settings;
}

constexpr std::uint32_t not_counted = ~0u;

/// Which lights are blocked where the ball is seen and faces the light, by more than this cosine, computed from the
/// numbers there.
Image<std::uint32_t> dark_pixels(double distance, const Settings& settings, double least_cosine,
                                 const StabilityRun& run) {
  const Vec3d light_from_centre(2, 2, -3);
  const Scene scene = parse_scene(world_text(distance), "world", ".");
  const int side = run.side(600, 300);
  Frame frame =
      picture_of(scene, {scene.camera, side, side}, settings, Channel::shadow | Channel::ids | Channel::normal, run);
  for (std::size_t i = 0; i < frame.shadow.pixels().size(); ++i) {
    const Vec3d normal(frame.normal.pixels()[i]);
    const Vec3d to_light = light_from_centre - normal;
    const bool faces = dot(normal, to_light) > least_cosine * std::sqrt(dot(to_light, to_light));
    if (frame.ids.pixels()[i].object < 0 || !faces) frame.shadow.pixels()[i] = not_counted;
  }
  return frame.shadow;
}

/// What the ball shadows of itself, of what is lit at the origin. A pixel that sees past the ball where numbers are
/// coarse is not counted: that is another fault.
void measure(const StabilityRun& run, Rows& rows) {
  Settings exact;
  exact.precision = Precision::float64;
  const auto truth = dark_pixels(0, exact, 0, run);
  const auto share = [&](const Image<std::uint32_t>& dark) {
    double lit = 0, wrong = 0;
    for (std::size_t i = 0; i < truth.pixels().size(); ++i) {
      if (truth.pixels()[i] != 0 || dark.pixels()[i] == not_counted) continue;
      ++lit;
      wrong += dark.pixels()[i] != 0 ? 1 : 0;
    }
    return percent(wrong, lit);
  };
  for (const double distance : {0.0, 10.0, 1e3, 1e4, 1e5, 1e6}) {
    // The place itself is rounded by up to half a step of the numbers there, a thirty-second of the radius at 1e6:
    // edge-on it may lie in shadow indeed.
    const double half_step = 0x1p-24 * distance;
    const double robust = share(dark_pixels(distance, in_the_world(), std::min(0.02, half_step), run));
    for (const double epsilon : {1e-3, 1e-2})
      rows.add(distance, fmt::format("epsilon {}", epsilon),
               share(dark_pixels(distance, with_epsilon(epsilon), 0, run)), robust,
               "% of lit pixels in their own shadow");
  }
}

StabilityPicture picture(double distance) {
  StabilityPicture picture{.scene = world_text(distance)};
  picture.robust = in_the_world();
  picture.naive = with_epsilon(1e-3);
  return picture;
}

}  // namespace

extern const StabilityExperiment world_offset_sphere_acne{
    .key = "world-offset-sphere-acne",
    .place = {Subject::rays, 70},
    .title = "Shadow acne far from the origin",
    .keywords = "shadow acne, large world, floating origin, self-intersection, camera-relative",
    .knob = "distance of the world along each axis",
    .naive = "ignore hits up to epsilon",
    .robust = "bounded offset, no epsilon",
    .explanation = "A point far from the origin is rounded to a coarser grid, so it lies farther off its surface. An "
                   "epsilon that is enough near the origin is soon smaller than that.",
    .safe = "Up to 10 units for 0.001, or anywhere with camera-relative = on.",
    .window = {nowhere, 10},
    .series = {{.names = "epsilon 0.001|*", .title = "lit pixels in their own shadow", .unit = "%"}},
    .add_rows = measure,
    .picture = picture,
    .frames = {0.0, 1e3, 1e4, 1e5, 1e6}};

}  // namespace ps::stability::world_offset_sphere_acne
