#include "options/rows.h"

namespace ps::rows {
namespace {

Reason needs_depth_buffer(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_fragments(s, t)) return reason;
  if (s.visibility != Visibility::depth_buffer) return "needs visibility = depth-buffer";
  return {};
}

Reason needs_triangles(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_fragments(s, t)) return reason;
  if (!t.triangles && !t.spheres) return "the scene has no triangles";
  return {};
}

}  // namespace

std::vector<Option> visibility_rows() {
  return {
      choice<&Settings::visibility>(
          {.key = "visibility",
           .label = "Hidden surfaces",
           .help = {"How the rasterizer decides which triangle is in front.", "CGFS ch. 12",
                    "Draw order and the painter's algorithm fail where triangles overlap in a circle or cross."},
           .inactive = needs_triangles},
          {{"depth-buffer", "depth buffer", "Each pixel remembers the depth of what it shows."},
           {"painter", "painter", "Triangles are sorted by their mean depth and drawn from back to front."},
           {"draw-order", "draw order", "Whatever is drawn last wins."}}),
      choice<&Settings::depth_value>(
          {.key = "depth-value",
           .label = "Depth value",
           .help =
               {"What the depth buffer stores and interpolates along the screen.", "CGFS ch. 12",
                "z is not linear on the screen: midway between z = 2 and z = 10 it says 6 where the truth is 3.33."},
           .inactive = needs_depth_buffer},
          {{"inverse-z", "1/z", "Linear on the screen, so interpolation is exact."},
           {"z", "z, interpolated linearly", "Wrong between the corners; close surfaces may swap."},
           {"distance", "distance to the eye", "Taken per pixel from the perspective-correct position."}}),
      toggle<&Settings::backface_culling>(
          {.key = "backface-culling",
           .label = "Back-face culling",
           .help = {"Drops triangles that turn their back to the camera.", "CGFS ch. 12",
                    "Open models show holes, since their insides are back faces."},
           .inactive = needs_triangles}),
      choice<&Settings::clipping>(
          {.key = "clipping",
           .label = "Clipping",
           .help = {"Cuts triangles at the planes of the view before projecting them.", "CGFS ch. 11",
                    "Without the near plane, points behind the camera are projected upside down."},
           .inactive = needs_triangles},
          {{"full", "near and sides", "Near plane and four side planes; triangles are split where they cross one."},
           {"near", "near plane only", "The picture's borders do the rest, pixel by pixel."},
           {"none", "none", "Shows why clipping is needed."}}),
  };
}

}  // namespace ps::rows
