#include <array>

#include <fmt/format.h>

#include "scene/scene_file.h"
#include "study/stability/shadow_floor.h"

namespace ps::stability {
namespace {

/// A floor in the light of the sun right above, 3 below a roof of 6 x 6 and 0.2. The floor is all but opaque, so that
/// it throws no shadow: the roof's is the only volume.
std::string roof_text(const Vec3d& eye) {
  return fmt::format("viewport_size = 1.5 x 1\nprojection_plane_d = 1\nbackground = (150, 190, 230)\n"
                     "camera {{ position = ({}, {}, {}) }}\n"
                     "rectangle {{ name = floor corner = (-60, -1, -20) side_a = (120, 0, 0) side_b = (0, 0, 45)\n"
                     "            color = (230, 225, 210) transparency = 0.000001 }}\n"
                     "box {{ name = roof center = (0, 2.1, 0) size = (6, 0.2, 6) color = (150, 110, 80) }}\n"
                     "light {{ type = ambient intensity = 0.25 }}\n"
                     "light {{ type = directional intensity = 0.75 direction = (0, 1, 0) }}\n",
                     eye.x, eye.y, eye.z);
}
const Vec3d outside(0.2, 3, -18), inside(0.2, 0.3, -2.5);

Settings depth_fail() { return shadow_settings(Renderer::rasterizer, Shadows::stencil_depth_fail, 0.05); }
Settings without_caps(double length) {
  Settings settings = depth_fail();
  settings.volume_caps = false;
  settings.volume_length = length;
  return settings;
}

std::vector<StabilityRow> measure(const StabilityRun& run) {
  Rows rows(run);
  const Scene from_outside = parse_scene(roof_text(outside), "roof", "."),
              from_inside = parse_scene(roof_text(inside), "roof", ".");
  const auto add = [&](double knob, const char* series, const Scene& scene, const Settings& naive, Settings robust) {
    rows.push_back({knob, series, wrong_floor_share(scene, naive, run), wrong_floor_share(scene, robust, run),
                    "% of floor pixels wrong"});
  };
  const auto open = [&](const char* series, const Scene& scene, double length) {
    Settings closed = without_caps(length);
    closed.volume_caps = true;
    add(length, series, scene, without_caps(length), closed);
  };
  for (const double length : {4.0, 6.0, 8.0, 9.0, 10.0}) open("no caps, camera outside", from_outside, length);
  for (const double length : {3.4, 4.2, 5.0}) open("no caps, camera inside", from_inside, length);
  for (const double length : {1.5, 3.0, 4.0, 10.0}) {
    Settings naive = depth_fail();
    naive.volume_length = length;
    add(length, "short volume", from_outside, naive, depth_fail());
  }
  for (const double far : {10.0, 17.0, 20.0, 40.0, 1000.0}) {
    Settings naive = depth_fail();
    naive.far = far;
    Settings robust = naive;
    naive.volume_depth_clamp = false;
    add(far, "far plane", from_outside, naive, robust);
  }
  return rows;
}

StabilityPicture picture(double length) {
  StabilityPicture picture{.scene = roof_text(outside), .width = 240, .height = 160};
  picture.naive = picture.robust = without_caps(length);
  picture.robust.volume_caps = true;
  return picture;
}

constexpr std::array frames{4.0, 6.0, 9.0, 10.0};

}  // namespace

const StabilityExperiment z_fail_caps{
    .key = "z-fail-caps",
    .title = "Depth fail without its caps",
    .knob = "length of the volume, or far plane",
    .naive = "open, short or cut volumes",
    .robust = "caps at both ends, nothing cut at the far plane",
    .explanation =
        "Depth fail counts what lies behind a surface, so the volume must be closed there. Where a line of sight "
        "leaves through a cap that is missing, or behind the far plane, a face is not counted, and the roof's upper "
        "side "
        "lies in its own shadow.",
    .safe = "Closed volumes that reach beyond everything, with a far plane at infinity.",
    .window = nowhere_safe,
    .measure = measure,
    .picture = picture,
    .frames = frames};

}  // namespace ps::stability
