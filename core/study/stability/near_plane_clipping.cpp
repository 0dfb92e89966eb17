#include <fmt/format.h>

#include "scene/scene_file.h"
#include "study/stability/inner_pixels.h"

namespace ps::stability::near_plane_clipping {
namespace {

constexpr double near = 1;  ///< the book's: the projection plane
constexpr int side = 300;   ///< of the picture, px

/// A triangle on a floor 1 below the book's camera: two vertices lie 8 before it, the third one comes towards it and
/// goes on behind it.
std::string floor_text(double third_z) {
  return fmt::format("viewport_size = 1 x 1\nprojection_plane_d = 1\nbackground = (190, 215, 240)\n"
                     "model {{\n  name = floor\n  vertices {{ (-4, -1, 8) (4, -1, 8) (0, -1, {}) }}\n"
                     "  triangles {{ (0, 1, 2, (90, 140, 70)) }}\n}}\n"
                     "instance {{ model = floor position = (0, 0, 0) }}\n",
                     third_z);
}

Settings fragments(Clipping clipping) {
  Settings settings = unlit_fragments();
  settings.clipping = clipping;
  settings.near = near;
  return settings;
}

Owners picture_with(double third_z, const Settings& settings, const StabilityRun& run) {
  const Scene scene = parse_scene(floor_text(third_z), "floor", ".");
  const Frame frame = picture_of(scene, {scene.camera, side, side}, settings, Channel::ids, run);
  return owners_of(frame.ids, [](const PixelId& id) { return id.object; });
}

void measure(const StabilityRun& run, Rows& rows) {
  for (const double z : {3.0, 1.0, 0.5, -0.5, -1.0, -3.0, -10.0}) {
    Settings rays;
    rays.precision = Precision::float64;
    rays.near = near;
    const Owners truth = picture_with(z, rays, run);
    const auto wrong = [&](const Owners& shown) { return wrong_owners(truth, shown); };
    const double robust = wrong(picture_with(z, fragments(Clipping::full), run));
    const auto add = [&](const char* series, const Owners& shown) {
      rows.add(z, series, wrong(shown), robust, "% of the picture wrong");
    };
    const Settings none = fragments(Clipping::none);
    add("clipping = none", picture_with(z, none, run));
    add("clipping = near only", picture_with(z, fragments(Clipping::near_only), run));
    // Makeshifts that Pixelscope does not offer: without clipping, but with another triangle.
    add("drop the triangle", z < near ? Owners(side, side, background_owner) : picture_with(z, none, run));
    add("clamp z to the near plane", picture_with(std::max(z, near), none, run));
    add("take |z|", picture_with(std::abs(z), none, run));
  }
}

StabilityPicture picture(double z) {
  StabilityPicture picture{.scene = floor_text(z)};
  picture.naive = fragments(Clipping::none);
  picture.robust = fragments(Clipping::full);
  return picture;
}

}  // namespace

extern const StabilityExperiment near_plane_clipping{
    .key = "near-plane-clipping",
    .place = {Subject::depth, 80},
    .title = "Near-plane clipping: vertices behind the camera",
    .keywords = "clipping, frustum, behind the eye, w < 0",
    .knob = "z of one vertex of a floor (world units before the camera)",
    .naive = "project it without clipping, drop the triangle, or move the vertex",
    .robust = "clip the triangle at the near plane",
    .explanation =
        "Division by a negative z projects a point behind the camera to the opposite side of the picture, and a point "
        "at z = 0 to infinity. Only cutting the triangle at the near plane keeps its visible part right.",
    .safe = "Triangles wholly before the near plane.",
    .window = {near, everywhere},
    .series = {{.names = "clipping = none|*", .title = "wrong pixels of the picture", .unit = "%"}},
    .add_rows = measure,
    .picture = picture,
    .frames = {1.0, -0.5, -1.0, -3.0}};

}  // namespace ps::stability::near_plane_clipping
