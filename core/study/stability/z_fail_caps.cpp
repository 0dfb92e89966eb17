#include "scene/scene_file.h"
#include "study/stability/shadow_floor.h"

namespace ps::stability::z_fail_caps {
namespace {

constexpr double outside = -8, inside = 0;  ///< z of the camera; the roof's shadow lies between -2 and 2

Settings depth_fail() {
  return shadow_settings(renderer_for(PictureWay::fragments), Shadows::stencil_depth_fail, 0.05);
}
Settings of_length(double length) {
  Settings settings = depth_fail();
  settings.volume_length = length;
  return settings;
}
Settings without_caps(Settings settings) {
  settings.volume_caps = false;
  return settings;
}

void measure(const StabilityRun& run, Rows& rows) {
  const Scene from_outside = parse_scene(roof_text(outside), "roof", "."),
              from_inside = parse_scene(roof_text(inside), "roof", ".");
  const auto add = [&](double knob, const char* series, const Scene& scene, const Settings& naive,
                       const Settings& robust) {
    rows.add(knob, series, wrong_floor_share(scene, naive, run), wrong_floor_share(scene, robust, run),
             "% of floor pixels wrong");
  };
  // From 5 on volumes reach through the floor.
  for (const double length : {5.0, 10.0, 20.0, 40.0, 80.0}) {
    add(length, "no caps, camera outside", from_outside, without_caps(of_length(length)), of_length(length));
    add(length, "no caps, camera inside", from_inside, without_caps(of_length(length)), of_length(length));
  }
  for (const double length : {1.0, 2.0, 4.0, 5.0, 10.0})
    add(length, "short volume", from_outside, of_length(length), depth_fail());
  for (const double far : {10.0, 20.0, 40.0, 80.0, 1000.0}) {
    Settings clamped = depth_fail();
    clamped.far = far;
    Settings cut = clamped;
    cut.volume_depth_clamp = false;
    add(far, "far plane", from_outside, cut, clamped);
  }
}

StabilityPicture picture(double length) {
  StabilityPicture picture{.scene = roof_text(outside), .width = 240, .height = 160};
  picture.naive = without_caps(of_length(length));
  picture.robust = of_length(length);
  return picture;
}

}  // namespace

extern const StabilityExperiment z_fail_caps{
    .key = "z-fail-caps",
    .place = {Subject::shadows, 60},
    .title = "Depth-fail stencil: volumes without caps",
    .keywords = "Carmack, shadow volume, stencil shadow, depth fail, cap",
    .knob = "length of the volumes (world units)",
    .naive = "open volumes, short ones, or volumes cut at the far plane",
    .robust = "caps at both ends, nothing cut at the far plane",
    .explanation = "Depth fail counts the faces of volumes behind a surface, so volumes must be closed there. If a "
                   "line of sight leaves a volume through a missing cap or behind the far plane, a face is not "
                   "counted. A lit floor then lies in its own shadow.",
    .safe = "Closed volumes that reach beyond everything, with a far plane at infinity.",
    .window = nowhere_safe,
    .series = {{.names = "no caps, camera outside|*", .title = "wrong pixels of the floor", .unit = "%"},
               {.names = "far plane",
                .title = "wrong pixels of the floor",
                .unit = "%",
                .knob = "distance of the far plane (world units)"}},
    .add_rows = measure,
    .picture = picture,
    .frames = {5.0, 10.0, 20.0, 40.0}};

}  // namespace ps::stability::z_fail_caps
