#include "options/rows.h"

namespace ps::rows {
namespace {

Reason needs_depth_buffer(const Settings& s, const SceneTraits&) {
  if (s.visibility != Visibility::depth_buffer) return needs("visibility", Visibility::depth_buffer);
  return {};
}

bool keeps_stencil_of_shadows(const Settings& s) {
  return (s.shadows == Shadows::stencil_depth_fail || s.shadows == Shadows::stencil_depth_pass) &&
         s.visibility == Visibility::depth_buffer;
}
/// With the conditions of needs_translucent().
bool blends_when_drawn(const Settings& s) {
  return s.blending != Blending::off && fills(s.draw) && !keeps_stencil_of_shadows(s);
}
Reason needs_translucent(const Settings& s, const SceneTraits& t) {
  if (!t.transparent) return "no material of the scene is transparent";
  if (const auto reason = needs_filled_fragments(s)) return reason;
  if (keeps_stencil_of_shadows(s))
    return needs("shadows", Shadows::map).because("a stencil holds the shadows of one surface of each pixel");
  return {};
}

/// A pass that first determines the visible surfaces needs a depth buffer with one sample per pixel.
Reason needs_passes(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_depth_buffer(s, t)) return reason;
  if (s.draw != Draw::filled) return needs("draw", Draw::filled);
  if (s.multisampling > 1) return needs("multisampling", 1);
  if (blends_when_drawn(s)) return needs("blending", Blending::off).because("a pass keeps one surface of each pixel");
  return {};
}
Reason needs_single_pass_lights(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_passes(s, t)) return reason;
  if (s.light_passes == LightPasses::many && s.lighting && s.shading == Shading::phong)
    return needs("light-passes", LightPasses::one)
        .said("no effect: light-passes = many already starts with a depth pass");
  return {};
}
Reason needs_early_depth(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_single_pass_lights(s, t)) return reason;
  if (s.deferred_shading)
    return needs("deferred-shading", false).said("no effect: deferred shading shades only visible surfaces");
  return {};
}
Reason needs_light_passes(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_passes(s, t)) return reason;
  if (!s.lighting) return needs("lighting", true).said("needs lighting");
  if (s.shading != Shading::phong)
    return needs("shading", Shading::phong).because("other shading evaluates the lighting per vertex or triangle");
  return {};
}

/// Only 1 / z can represent every depth up to infinity.
Reason needs_range(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_depth_buffer(s, t)) return reason;
  if (s.depth_value != DepthValue::inverse_z && s.far >= no_far_limit)
    return IdleReason({{"depth-value", static_cast<double>(DepthValue::inverse_z)}, {"far", some_far_limit}})
        .said("needs a far limit, unless depth-value = inverse-z");
  return {};
}
Reason needs_integers(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_range(s, t)) return reason;
  if (s.depth_format != DepthFormat::unorm) return needs("depth-format", DepthFormat::unorm);
  return {};
}
Reason needs_unit_range(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_range(s, t)) return reason;
  if (s.depth_format == DepthFormat::plain)
    return needs("depth-format", DepthFormat::unit_float, DepthFormat::unorm).said("needs a depth-format from 0 to 1");
  return {};
}

Reason needs_triangles(const Settings&, const SceneTraits& t) {
  if (!t.triangles && !t.spheres) return "the scene has no triangles";
  return {};
}

constexpr std::string_view one_pass = "SIMD needs one pass: no early depth, deferred shading or light passes";

/// The hardware renderer draws light that is computed at vertices light by light, where each has a shadow of its own.
Reason deferred_lacks(OptionNumber on, const Settings& s) {
  const bool at_vertices = s.lighting && s.shading != Shading::phong;
  const bool by_light = s.shadows != Shadows::none && s.shadows != Shadows::traced;
  if (on != 0 && at_vertices && by_light)
    return needs("shading", Shading::phong)
        .said("a buffer that holds the light of vertices holds the sum of all lights, and shadows need each by itself");
  return {};
}

}  // namespace

std::vector<Option> visibility_rows() {
  return {
      choice<&Settings::visibility>(
          {.key = "visibility",
           .label = "Hidden surfaces",
           .help = {"How the rasterizer decides which triangle is in front.", "CGFS ch. 12",
                    "Draw order and the painter's algorithm fail where triangles overlap cyclically or intersect."},
           .keywords =
               "z-buffer, zbuffer, depth buffer off, depth test off, disable, without depth buffer, no depth test, "
               "hidden surface, painter's algorithm, draw order, occlusion",
           .truth = exactly("visibility=depth-buffer"),
           .acts_for = ActsFor::fragments,
           .inactive = needs_triangles,
           .known_to = {.fast = {knows(whole_tiles, 10, Visibility::depth_buffer)}, .hardware = any_value},
           .shown_by = {.experiments = {{"painter-s-cycle", is_not<&Settings::visibility, Visibility::depth_buffer>,
                                         "visibility=depth-buffer"}},
                        .scenes = {{"cgfs/depth"}}}},
          {{"depth-buffer", "depth buffer", "Each pixel stores the depth of its visible surface."},
           {"painter", "painter", "Triangles are sorted by their mean depth and drawn from back to front."},
           {"draw-order", "draw order", "The triangle that is drawn last is visible."}}),
      choice<&Settings::depth_value>(
          {.key = "depth-value",
           .label = "Depth value",
           .help = {"What the depth buffer stores, and how it is found at each sample: interpolated along the screen, "
                    "or from the ray of the sample.",
                    "CGFS ch. 12; OCT (ray-plane-intersection)",
                    "z is not linear on the screen: midway between z = 2 and z = 10 interpolation gives 6, and the "
                    "true depth is 3.33."},
           .keywords = "z-buffer, zbuffer, depth buffer, w-buffer, 1/z, linear depth",
           .truth = exactly("depth-value=inverse-z"),
           .acts_for = ActsFor::fragments,
           .inactive = needs_depth_buffer,
           .known_to = {.fast = {limit(fragment_batches, 80,
                                       "SIMD interpolates depth: it needs another depth-value than ray-plane",
                                       [](const Settings& s, const SceneTraits&) {
                                         return s.visibility == Visibility::depth_buffer &&
                                                s.depth_value == DepthValue::ray_plane;
                                       }),
                                 knows(whole_tiles, 20, DepthValue::inverse_z)},
                        .hardware = lacking("the hardware renderer has no plane equations: depth is interpolated",
                                            DepthValue::ray_plane)},
           .shown_by = {.experiments = {{"z-vs-1-z", is<&Settings::depth_value, DepthValue::z>,
                                         "depth-value=inverse-z"},
                                        {"16-bit-linear-z"}},
                        .scenes = {{"lab/z-fighting"}}}},
          {{"inverse-z", "1/z", "Linear on the screen, so interpolation is exact."},
           {"z", "z, interpolated linearly", "Wrong between the vertices; surfaces close to each other may swap."},
           {"distance", "distance to the eye", "Computed per pixel from the perspective-correct position."},
           {"ray-plane", "z by ray and plane",
            "The z at which the sample's ray meets the triangle's plane. It costs a plane for each triangle and a "
            "division for each sample, without SIMD. It is the true z: neither vertices rounded to sub-pixels nor "
            "clipping change it."}}),
      choice<&Settings::depth_format>(
          {.key = "depth-format",
           .label = "Depth format",
           .help = {"Number format in which the depth buffer stores its value.",
                    "CGFS ch. 12; the depth formats of Direct3D and OpenGL",
                    "With a range from 0 to 1, most values lie just behind the near plane. Far surfaces close to each "
                    "other then get equal depths and mix (z-fighting)."},
           .keywords = "z-buffer, zbuffer, depth buffer, z-fighting, depth precision, unorm, integer depth",
           .truth = exactly("depth-format=plain"),
           .acts_for = ActsFor::fragments,
           .inactive = needs_range,
           .known_to = {.fast = {knows(fragment_batches, 70, DepthFormat::plain)}, .hardware = any_value},
           .shown_by = {.experiments = {{"depth-bits-z-fighting",
                                         [](const Settings& s) {
                                           return s.depth_format == DepthFormat::unorm ||
                                                  (s.depth_format == DepthFormat::unit_float && !s.depth_reversed);
                                         },
                                         "depth-format=plain"}},
                        .scenes = {{"lab/z-fighting"}}}},
          {{"plain", "plain float", "1/z, z or the distance as a floating-point number."},
           {"unit-float", "float, 0 to 1", "0 at the near plane, 1 at the far one, as 32-bit float."},
           {"unorm", "integer, 0 to 1", "The same as an integer with depth-bits bits."}}),
      integer<&Settings::depth_bits>(
          {.key = "depth-bits",
           .label = "Depth bits",
           .help = {"Bits of an integer depth buffer: two surfaces at depth z need a gap of about z^2 / (near 2^bits).",
                    "CGFS ch. 12; LAB 5", "Each bit less doubles that gap."},
           .keywords = "z-buffer, zbuffer, depth buffer, z-fighting, depth precision, 16 bit, 24 bit",
           .truth = exactly("depth-format=plain"),
           .acts_for = ActsFor::fragments,
           .inactive = needs_integers,
           .known_to = {.fast = any_value, .hardware = any_value},
           .shown_by = {.experiments = {{"depth-bits-z-fighting"}, {"16-bit-linear-z"}},
                        .scenes = {{"lab/z-fighting"}}}},
          4, 24, "bits"),
      toggle<&Settings::depth_reversed>(
          {.key = "depth-reversed",
           .label = "Reversed depth",
           .help = {"Stores 1 at the near plane and 0 at the far plane: floats are "
                    "densest near 0, where 1/z crowds distant surfaces.",
                    "the clip-control depth range of Direct3D and OpenGL",
                    "No gain for integers, whose steps are equal."},
           .keywords = "reversed z, reverse z, z-buffer, zbuffer, z-fighting, depth precision",
           .truth = exactly("depth-format=plain"),
           .acts_for = ActsFor::fragments,
           .inactive = needs_unit_range,
           .known_to = {.fast = any_value, .hardware = any_value},
           .shown_by = {.experiments = {{"depth-bits-z-fighting"}, {"near-plane"}},
                        .scenes = {{"lab/z-fighting", "depth-format=unit-float"}}}}),
      toggle<&Settings::early_depth>(
          {.key = "early-depth",
           .label = "Early depth pass",
           .help = {"Draws all triangles twice: the first pass writes only depth, the second shades only visible "
                    "fragments.",
                    "CGPP 15.8.3",
                    "Coverage is computed twice; worthwhile if shading is expensive and overdraw is high."},
           .keywords = "early z, z prepass, depth prepass, overdraw, z-buffer",
           .truth = as_set(),
           .acts_for = ActsFor::fragments,
           .inactive = needs_early_depth,
           .known_to = {.fast = {limit(fragment_batches, 90, one_pass,
                                       [](const Settings& s, const SceneTraits& t) {
                                         return s.early_depth && !needs_passes(s, t);
                                       })},
                        .hardware = any_value},
           .shown_by = {.experiments = none, .scenes = {{"lab/depth-complexity"}}}}),
      toggle<&Settings::deferred_shading>(
          {.key = "deferred-shading",
           .label = "Deferred shading",
           .help = {"Stores the visible surface of each pixel (G-buffer) and shades each pixel once at the end.",
                    "CGPP 15.8.3", "Needs memory for the G-buffer, which stores one surface per pixel."},
           .keywords = "g-buffer, deferred rendering, overdraw",
           .truth = as_set(),
           .acts_for = ActsFor::fragments,
           .inactive = needs_single_pass_lights,
           .known_to = {.fast = {limit(fragment_batches, 90, one_pass,
                                       [](const Settings& s, const SceneTraits& t) {
                                         return s.deferred_shading && !needs_passes(s, t);
                                       })},
                        .hardware = lacking_if(deferred_lacks)},
           .shown_by = {.experiments = none, .scenes = {{"lab/depth-complexity"}}}}),
      choice<&Settings::light_passes>(
          {.key = "light-passes",
           .label = "Lights",
           .help =
               {"Shades a fragment under all lights at once, or draws the triangles once for each light and adds up "
                "the passes.",
                "CGPP 15.7.2.3",
                "Each additional light is another pass over all triangles, and the sum is rounded after each pass."},
           .keywords = "multipass, forward rendering, additive blending, many lights",
           .truth = as_set(),
           .acts_for = ActsFor::fragments,
           .inactive = needs_light_passes,
           .known_to = {.fast = {limit(fragment_batches, 90, one_pass,
                                       [](const Settings& s, const SceneTraits& t) {
                                         return s.light_passes == LightPasses::many && !needs_light_passes(s, t);
                                       })},
                        .hardware = any_value},
           .shown_by = {.experiments = none, .scenes = {{"lab/depth-complexity"}}}},
          {{"one", "in one pass", "Evaluates all lights when a fragment is shaded."},
           {"many", "one pass each", "Draws one depth pass, then one pass for each light."}}),
      choice<&Settings::blending>(
          {.key = "blending",
           .label = "Blending",
           .help = {"How the output merger treats translucent surfaces: fragment times opacity, plus pixel times "
                    "transparency.",
                    "CGPP 15.7.1.3",
                    "In draw order, a surface hides what lies behind it and is drawn later. Sorted triangles are still "
                    "wrong where they cross or overlap in a circle."},
           .keywords = "alpha blending, over operator, translucent, opacity, output merger, "
                       "order-dependent, back to front",
           .truth = exactly("blending=sorted"),
           .acts_for = ActsFor::fragments,
           .inactive = needs_translucent,
           .known_to = {.fast = {limit(fragment_batches, 95, "SIMD replaces colours: it needs blending = off",
                                       [](const Settings& s, const SceneTraits& t) {
                                         return s.blending != Blending::off && !needs_translucent(s, t);
                                       })},
                        .hardware = lacking("the hardware renderer's passes replace the colours of surfaces", 1, 2)},
           .shown_by = {.experiments = none, .scenes = {{"lab/translucent-sheets"}}}},
          {{"off", "off", "Translucent surfaces are drawn as opaque; an opacity map below 1/2 cuts them out."},
           {"draw-order", "in draw order", "Blends fragments as triangles come, and each writes its depth."},
           {"sorted", "sorted",
            "Draws opaque triangles first, then translucent ones from back to front, which write no depth."}}),
      toggle<&Settings::backface_culling>(
          {.key = "backface-culling",
           .label = "Back-face culling",
           .help = {"Drops triangles whose back faces the camera.", "CGFS ch. 12",
                    "Open models show holes, because their inner sides are back faces."},
           .keywords = "back face, cull face, winding, one-sided, front face",
           .truth = exactly("backface-culling=off"),
           .acts_for = ActsFor::fragments,
           .inactive = needs_triangles,
           .known_to = {.fast = any_value, .hardware = any_value},
           .shown_by = {.experiments = none, .scenes = {{"cgfs/depth"}}}}),
      choice<&Settings::clipping>(
          {.key = "clipping",
           .label = "Clipping",
           .help = {"Clips triangles at the planes of the view volume before projecting them.", "CGFS ch. 11",
                    "Without the near plane, points behind the camera are projected upside down."},
           .keywords = "frustum, near plane, Sutherland-Hodgman, behind the camera, guard band",
           .truth = exactly("clipping=full"),
           .acts_for = ActsFor::fragments,
           .inactive = needs_triangles,
           .known_to = {.fast = any_value,
                        .hardware = lacking("a driver draws nothing that lies behind the eye", Clipping::none)},
           .shown_by = {.experiments = {{"near-plane-clipping", is<&Settings::clipping, Clipping::none>,
                                         "clipping=full"}},
                        .scenes = {{"cgfs/behind", "subpixel-bits=12;clipping=near"}}}},
          {{"full", "near and sides",
            "Clips at the near plane and the four side planes; triangles that cross a plane are split."},
           {"near", "near plane only", "Only the near plane clips; pixels outside the image are skipped."},
           {"none", "none", "No clipping: shows why it is needed."}}),
  };
}

}  // namespace ps::rows
