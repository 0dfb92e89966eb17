#include "options/rows.h"

namespace ps::rows {
namespace {

Reason needs_depth_buffer(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_fragments(s, t)) return reason;
  if (s.visibility != Visibility::depth_buffer) return "needs visibility = depth-buffer";
  return {};
}

/// What first finds out what is visible needs a depth buffer with one sample a pixel.
Reason needs_passes(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_depth_buffer(s, t)) return reason;
  if (s.draw != Draw::filled) return "needs draw = filled";
  if (s.multisampling > 1) return "needs multisampling = 1";
  return {};
}
Reason needs_single_pass_lights(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_passes(s, t)) return reason;
  if (s.light_passes == LightPasses::many && s.lighting && s.shading == Shading::phong)
    return "light-passes = many finds out what is visible anyway";
  return {};
}
Reason needs_early_depth(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_single_pass_lights(s, t)) return reason;
  if (s.deferred_shading) return "deferred shading shades only what is visible anyway";
  return {};
}
Reason needs_light_passes(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_passes(s, t)) return reason;
  if (!s.lighting) return "needs lighting";
  if (s.shading != Shading::phong) return "needs shading = phong: other shading lights corners";
  return {};
}

/// 1 / z alone has a place for everything up to infinity.
Reason needs_range(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_depth_buffer(s, t)) return reason;
  if (s.depth_value != DepthValue::inverse_z && s.far >= 1e30)
    return "needs a far limit, unless depth-value = inverse-z";
  return {};
}
Reason needs_integers(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_range(s, t)) return reason;
  if (s.depth_format != DepthFormat::unorm) return "needs depth-format = unorm";
  return {};
}
Reason needs_unit_range(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_range(s, t)) return reason;
  if (s.depth_format == DepthFormat::plain) return "needs a depth-format from 0 to 1";
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
           .truth = exactly("visibility=depth-buffer"),
           .inactive = needs_triangles},
          {{"depth-buffer", "depth buffer", "Each pixel remembers the depth of what it shows."},
           {"painter", "painter", "Triangles are sorted by their mean depth and drawn from back to front."},
           {"draw-order", "draw order", "Whatever is drawn last wins."}}),
      choice<&Settings::depth_value>(
          {.key = "depth-value",
           .label = "Depth value",
           .help =
               {"What the depth buffer stores, and how it is found at each sample: interpolated along the screen, or "
                "from "
                "the sample's own ray.",
                "CGFS ch. 12; OCT (ray-plane-intersection)",
                "z is not linear on the screen: midway between z = 2 and z = 10 it says 6 where the truth is 3.33."},
           .truth = exactly("depth-value=inverse-z"),
           .inactive = needs_depth_buffer},
          {{"inverse-z", "1/z", "Linear on the screen, so interpolation is exact."},
           {"z", "z, interpolated linearly", "Wrong between the corners; close surfaces may swap."},
           {"distance", "distance to the eye", "Taken per pixel from the perspective-correct position."},
           {"ray-plane", "z by ray and plane",
            "The z at which the sample's ray meets the triangle's plane. It costs a plane for each triangle and a "
            "division for each sample, and nothing draws it several samples at a time; it gives the true z, untouched "
            "by the rounding of corners to sub-pixels and by clipping."}}),
      choice<&Settings::depth_format>(
          {.key = "depth-format",
           .label = "Depth format",
           .help =
               {"How the depth buffer holds its value.", "CGFS ch. 12; the depth formats of Direct3D and OpenGL",
                "From 0 at the near plane to 1, most of the range lies just behind the near plane: far surfaces that "
                "are close to each other get equal depths and mix, which is called z-fighting."},
           .truth = exactly("depth-format=plain"),
           .inactive = needs_range},
          {{"plain", "the value itself", "1/z, z or the distance as a floating-point number."},
           {"unit-float", "float, 0 to 1", "0 at the near plane, 1 at the far one, as 32-bit float."},
           {"unorm", "integer, 0 to 1", "The same in steps of one, of as many bits as depth-bits says."}}),
      integer<&Settings::depth_bits>(
          {.key = "depth-bits",
           .label = "Depth bits",
           .help = {"The steps of an integer depth buffer: two surfaces at z need a gap of about z^2 / (near 2^bits).",
                    "CGFS ch. 12; LAB 5", "Each bit fewer doubles the gap that is needed."},
           .truth = exactly("depth-format=plain"),
           .inactive = needs_integers},
          4, 24, "bits"),
      toggle<&Settings::depth_reversed>(
          {.key = "depth-reversed",
           .label = "Reversed depth",
           .help =
               {"1 at the near plane, 0 at the far one: float is finest near 0, where 1/z crowds all that is far away.",
                "the clip-control depth range of Direct3D and OpenGL",
                "Integers have equal steps, so they gain nothing."},
           .truth = exactly("depth-format=plain"),
           .inactive = needs_unit_range}),
      toggle<&Settings::early_depth>(
          {.key = "early-depth",
           .label = "Early depth pass",
           .help = {"Draws all triangles twice: first their depth alone, then only what is visible is shaded.",
                    "CGPP 15.8.3", "Coverage is done twice; it pays where shading is dear and many surfaces overlap."},
           .truth = as_set(),
           .inactive = needs_early_depth}),
      toggle<&Settings::deferred_shading>(
          {.key = "deferred-shading",
           .label = "Deferred shading",
           .help = {"Keeps which triangle each pixel shows, and where on it, and shades each pixel once at the end.",
                    "CGPP 15.8.3", "Needs memory for what is kept of each pixel, and knows one surface a pixel."},
           .truth = as_set(),
           .inactive = needs_single_pass_lights}),
      choice<&Settings::light_passes>(
          {.key = "light-passes",
           .label = "Lights",
           .help =
               {"Whether a fragment is shaded under all lights at once or the triangles are drawn once for each light, "
                "each pass adding to the picture.",
                "CGPP 15.7.2.3", "Every light more is another walk over all triangles, and sums are rounded between."},
           .truth = as_set(),
           .inactive = needs_light_passes},
          {{"one", "in one pass", "All lights when a fragment is shaded."},
           {"many", "one pass each", "A pass for the depth, then one for each light."}}),
      toggle<&Settings::backface_culling>(
          {.key = "backface-culling",
           .label = "Back-face culling",
           .help = {"Drops triangles that turn their back to the camera.", "CGFS ch. 12",
                    "Open models show holes, since their insides are back faces."},
           .truth = exactly("backface-culling=off"),
           .inactive = needs_triangles}),
      choice<&Settings::clipping>(
          {.key = "clipping",
           .label = "Clipping",
           .help = {"Cuts triangles at the planes of the view before projecting them.", "CGFS ch. 11",
                    "Without the near plane, points behind the camera are projected upside down."},
           .truth = exactly("clipping=full"),
           .inactive = needs_triangles},
          {{"full", "near and sides", "Near plane and four side planes; triangles are split where they cross one."},
           {"near", "near plane only", "The picture's borders do the rest, pixel by pixel."},
           {"none", "none", "Shows why clipping is needed."}}),
  };
}

}  // namespace ps::rows
