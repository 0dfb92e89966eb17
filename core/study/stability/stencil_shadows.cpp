#include <fmt/format.h>

#include "scene/scene_file.h"
#include "study/stability/shadow_floor.h"

namespace ps::stability::stencil_shadows {
namespace {

/// What depth pass makes of the floor, and what depth fail does.
void add_passed_and_failed(Rows& rows, double knob, const char* series, const Scene& scene, double near,
                           const StabilityRun& run) {
  const auto wrong = [&](Shadows shadows) {
    return wrong_floor_share(scene, shadow_settings(renderer_for(PictureWay::fragments), shadows, near), run);
  };
  rows.add(knob, series, wrong(Shadows::stencil_depth_pass), wrong(Shadows::stencil_depth_fail),
           "% of floor pixels wrong");
}

void measure_inside(const StabilityRun& run, Rows& rows) {
  for (const double z : {-8.0, -6.0, -4.0, -3.0, -1.5, 0.0}) {
    const Scene scene = parse_scene(roof_text(z), "roof", ".");
    add_passed_and_failed(rows, z, "under a roof of 4 x 4", scene, 0.05, run);
  }
}

void measure_near(const StabilityRun& run, Rows& rows) {
  const Scene scene = parse_scene(roof_text(-2.05), "roof", ".");
  for (const double near : {0.01, 0.03, 0.1, 0.3, 0.6})
    add_passed_and_failed(rows, near, "camera 0.05 before the shadow", scene, near, run);
}

/// `boards` over one place, in the light from above.
std::string boards_text(int boards) {
  std::string text =
      "viewport_size = 1.5 x 1\nprojection_plane_d = 1\nbackground = white\ncamera { position = (0, 0, -3) }\n"
      "rectangle { corner = (-6, -1, -2) side_a = (12, 0, 0) side_b = (0, 0, 14) color = white }\n"
      "light { type = ambient intensity = 0.25 }\n"
      "light { type = directional intensity = 0.75 direction = (0, 1, 0) }\n";
  for (int i = 0; i < boards; ++i)
    text += fmt::format("rectangle {{ corner = (-1, {}, 1) side_a = (2, 0, 0) side_b = (0, 0, 2) color = red }}\n",
                        1.5 + 0.01 * i);
  return text;
}

/// Percentage of the floor right under the boards that is lit.
double lit_share(int boards, int bits, const StabilityRun& run) {
  const Scene scene = parse_scene(boards_text(boards), "boards", ".");
  const View view{scene.camera, 90, 60};
  const Channel channels = Channel::ids | Channel::shadow;
  Settings settings = shadow_settings(renderer_for(PictureWay::fragments), Shadows::stencil_depth_fail, 0.1);
  settings.stencil_bits = bits;
  const Frame truth =
      picture_of(scene, view, shadow_settings(renderer_for(PictureWay::rays), Shadows::traced, 0.1), channels, run);
  const Frame frame = picture_of(scene, view, settings, channels, run);
  double dark = 0, lit = 0;
  for (int y = 1; y + 1 < 60; ++y)
    for (int x = 1; x + 1 < 90; ++x) {
      bool inner = true;
      for (const auto& [dx, dy] : {std::pair{0, 0}, {1, 0}, {-1, 0}, {0, 1}, {0, -1}})
        inner = inner && truth.ids.at(x + dx, y + dy).object == 0 && truth.shadow.at(x + dx, y + dy) != 0;
      if (!inner || frame.ids.at(x, y).object != 0) continue;
      ++dark;
      lit += frame.shadow.at(x, y) == 0 ? 1 : 0;
    }
  return percent(lit, dark);
}

void measure_wrap(const StabilityRun& run, Rows& rows) {
  for (const int boards : {1, 8, 15, 16, 17, 32})
    rows.add(boards, "4 bits", lit_share(boards, 4, run), lit_share(boards, 16, run), "% of shadow pixels lit");
  for (const int boards : {255, 256, 257})
    rows.add(boards, "8 bits", lit_share(boards, 8, run), lit_share(boards, 16, run), "% of shadow pixels lit");
}

StabilityPicture picture_inside(double z) {
  StabilityPicture picture{.scene = roof_text(z), .width = 240, .height = 160};
  picture.naive = shadow_settings(renderer_for(PictureWay::fragments), Shadows::stencil_depth_pass, 0.05);
  picture.robust = shadow_settings(renderer_for(PictureWay::fragments), Shadows::stencil_depth_fail, 0.05);
  return picture;
}
StabilityPicture picture_near(double near) {
  StabilityPicture picture = picture_inside(-2.05);
  picture.naive.near = picture.robust.near = near;
  return picture;
}
StabilityPicture picture_wrap(double boards) {
  StabilityPicture picture = picture_inside(0);
  picture.scene = boards_text(static_cast<int>(boards));
  picture.naive = picture.robust;
  picture.naive.stencil_bits = 4;
  picture.robust.stencil_bits = 16;
  return picture;
}

}  // namespace

extern const StabilityExperiment z_pass_in_volume{
    .key = "z-pass-in-volume",
    .place = {Subject::shadows, 40},
    .title = "Depth-pass stencil: camera inside a shadow volume",
    .keywords = "shadow volume, stencil shadow, depth pass, z-pass",
    .knob = "z of the camera (the shadow lies between -2 and 2)",
    .naive = "count faces before the surface (depth pass)",
    .robust = "count faces behind the surface (depth fail)",
    .explanation = "Depth pass assumes that the eye is lit. Inside a volume every count is one too low, so light and "
                   "shadow are exchanged.",
    .safe = "Cameras outside every volume.",
    .window = {nowhere, -2.5},
    .series = {{.names = "*", .title = "wrong pixels of the floor", .unit = "%"}},
    .add_rows = measure_inside,
    .picture = picture_inside,
    .frames = {-8.0, -4.0, -1.5, 0.0}};

extern const StabilityExperiment near_plane_cuts_volume{
    .key = "near-plane-cuts-volume",
    .place = {Subject::shadows, 50},
    .title = "Depth-pass stencil: the near plane cuts a volume",
    .keywords = "shadow volume, stencil shadow, near clip, z-pass, z-fail",
    .knob = "distance of the near plane (world units)",
    .naive = "count faces before the surface (depth pass)",
    .robust = "count faces behind the surface (depth fail)",
    .explanation = "The near plane removes the face through which a line of sight enters the volume, so that face is "
                   "not counted. Depth fail counts faces behind the surface, where no near plane cuts.",
    .safe = "Near planes that stay outside every volume.",
    .window = {nowhere, 0.03},
    .series = {{.names = "*", .title = "wrong pixels of the floor", .unit = "%"}},
    .add_rows = measure_near,
    .picture = picture_near,
    .frames = {0.01, 0.03, 0.1, 0.3}};

extern const StabilityExperiment stencil_bits_wrap{
    .key = "stencil-bits-wrap",
    .place = {Subject::shadows, 70},
    .title = "Stencil overflow: more shadows than the buffer counts",
    .keywords = "overflow, stencil buffer, shadow volume, counter, wrap-around",
    .knob = "volumes that overlap",
    .naive = "4 or 8 bits",
    .robust = "16 bits",
    .explanation = "A count of n bits returns to 0 after 2^n volumes, and 0 means lit. Every other number of volumes "
                   "gives a count that is not 0, so only multiples of 2^n fail.",
    .safe = "Fewer than 2^bits overlapping volumes.",
    .window = {nowhere, 15},
    .series = {{.names = "4 bits|*", .title = "shadow pixels that are lit", .unit = "%", .between = Between::nothing}},
    .add_rows = measure_wrap,
    .picture = picture_wrap,
    .frames = {8.0, 15.0, 16.0, 17.0}};

}  // namespace ps::stability::stencil_shadows
