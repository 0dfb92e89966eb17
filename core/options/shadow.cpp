#include "options/renderer_kind.h"
#include "options/rows.h"

namespace ps::rows {
namespace {

Reason needs_casting_light(const Settings& s, const SceneTraits& t) {
  if (draws_fragments(s.renderer) && s.draw != Draw::filled) return "needs draw = filled";
  if (!s.lighting) return "needs lighting = on";
  if (!t.casting_lights) return "the scene has no light that casts shadows";
  return {};
}

Reason needs_shadow_rays(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_rays(s, t)) return reason;
  if (const auto reason = needs_casting_light(s, t)) return reason;
  if (s.shadows == Shadows::none) return "needs shadows";
  return {};
}

Reason needs_shadow_map(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_fragments(s, t)) return reason;
  if (const auto reason = needs_casting_light(s, t)) return reason;
  if (s.shadows != Shadows::map) return "needs shadows = map";
  return {};
}

Reason needs_stencil(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_fragments(s, t)) return reason;
  if (const auto reason = needs_casting_light(s, t)) return reason;
  if (s.shadows != Shadows::stencil_depth_fail && s.shadows != Shadows::stencil_depth_pass)
    return "needs shadows = stencil-depth-fail or stencil-depth-pass";
  if (s.visibility != Visibility::depth_buffer) return "needs visibility = depth-buffer";
  return {};
}

Reason needs_depth_fail(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_stencil(s, t)) return reason;
  if (s.shadows != Shadows::stencil_depth_fail) return "needs shadows = stencil-depth-fail";
  return {};
}

Reason needs_cut_volumes(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_depth_fail(s, t)) return reason;
  if (s.far >= 1e30) return "needs a far limit";
  return {};
}

Reason needs_secondary_rays(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_rays(s, t)) return reason;
  const bool shadows = s.lighting && t.casting_lights && s.shadows != Shadows::none;
  const bool mirrors = t.reflective && s.reflection_depth > 0;
  if (!shadows && !mirrors) return "needs shadows or reflections";
  return {};
}

Reason needs_shadow_epsilon(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_shadow_rays(s, t)) return reason;
  if (s.self_hit == SelfHit::offset) return "needs self-hit = epsilon or normal-bump";
  return {};
}

Reason needs_epsilon(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_secondary_rays(s, t)) return reason;
  if (s.self_hit != SelfHit::epsilon) return "needs self-hit = epsilon";
  return {};
}

}  // namespace

std::vector<Option> shadow_rows() {
  return {
      choice<&Settings::shadows>(
          {.key = "shadows",
           .label = "Shadows",
           .help = {"Whether a light that cannot be seen from a point lights it, and how that is found out.",
                    "CGFS ch. 4 and 15; CGPP 15.6.5",
                    "The ray tracer sends a shadow ray to each light unless this is none. The "
                    "rasterizer has no rays: with traced it shows no shadows."},
           .truth = exactly("shadows=traced|stencil-depth-fail"),
           .inactive = needs_casting_light},
          {{"traced", "traced", "One shadow ray for each light; the rasterizer has none to send."},
           {"none", "none", "All lights shine through everything."},
           {"map", "shadow map",
            "Depth as seen from the light, six pictures around a point light: blocky edges, and "
            "acne without a bias."},
           {"stencil-depth-fail", "stencil, depth fail",
            "Counts the faces of shadow volumes behind the surface: exact edges, and right "
            "wherever the camera is."},
           {"stencil-depth-pass", "stencil, depth pass",
            "Counts those before the surface: wrong where the camera itself is in a shadow."}}),
      integer<&Settings::shadow_map_size>(
          {.key = "shadow-map-size",
           .label = "Shadow map size",
           .help =
               {"Texels along an edge of a shadow map; a point light has six of them.", "CGFS ch. 15",
                "Small maps make blocky shadows and more acne; large ones cost memory and time: at 4096 texels a point "
                "light takes 400 MB."},
           .truth = exactly("shadows=stencil-depth-fail"),
           .inactive = needs_shadow_map},
          8, 4096, "texels"),
      real<&Settings::shadow_bias>(
          {.key = "shadow-bias",
           .label = "Shadow map bias",
           .help = {"How much nearer to the light than it is a point pretends to be when its depth is compared.",
                    "CGFS ch. 15; Direct3D 11 15.10",
                    "Too small: acne, lit surfaces shadow themselves in stripes. Too large: shadows come off their "
                    "objects."},
           .truth = exactly("shadows=stencil-depth-fail"),
           .inactive = needs_shadow_map},
          0, 10, OptionScale::logarithmic, "world units"),
      real<&Settings::shadow_slope_bias>(
          {.key = "shadow-slope-bias",
           .label = "Slope bias",
           .help =
               {"A bias that grows with the slope of the surface as the light sees it: the depth that so many texels "
                "cover there. Added to the constant one.",
                "Direct3D 11 15.10",
                "A filter of k x k taps needs k / 2 texels where the slope runs along the map's axes, as on a floor, "
                "and 0.71 k on any surface; and 1/256 more, since the map's vertices are rounded. -1 stands for that, "
                "with the rounding of the depths themselves and how far triangles stray from round surfaces."},
           .truth = exactly("shadows=stencil-depth-fail"),
           .inactive = needs_shadow_map},
          -1, 16, OptionScale::linear, "texels"),
      integer<&Settings::shadow_filter>(
          {.key = "shadow-filter",
           .label = "Shadow map filter",
           .help = {"Percentage-closer filtering: how many texels along each side are compared, and their answers "
                    "averaged.",
                    "CGFS ch. 15", "Softens the blocks, but needs more bias, and costs the square of the number."},
           .truth = pixel_average("shadows=stencil-depth-fail"),
           .inactive = needs_shadow_map},
          1, 7, "taps"),
      integer<&Settings::stencil_bits>(
          {.key = "stencil-bits",
           .label = "Stencil bits",
           .help = {"Bits of a pixel's count of shadow volumes.", "CGFS ch. 15",
                    "The count wraps: where 2^bits shadows lie over each other, the pixel is lit."},
           .truth = exactly("stencil-bits=16"),
           .inactive = needs_stencil},
          1, 16, "bits"),
      toggle<&Settings::volume_caps>(
          {.key = "volume-caps",
           .label = "Volume caps",
           .help = {"Closes shadow volumes at both ends: with the triangles that the light falls on, and with the same "
                    "at the far end.",
                    "CGFS ch. 15; Everitt and Kilgard 2002",
                    "Depth fail counts behind the surface. Without caps, what a line of sight leaves or enters through "
                    "an end is not counted, and surfaces lie in their own shadow."},
           .truth = exactly("volume-caps=on"),
           .inactive = needs_depth_fail}),
      real<&Settings::volume_length>(
          {.key = "volume-length",
           .label = "Volume length",
           .help = {"How far shadow volumes reach from what throws the shadow; 0 = without end.",
                    "CGFS ch. 15; Everitt and Kilgard 2002",
                    "Beyond its volume's end an object casts no shadow. A short volume covers fewer pixels, which is "
                    "why programs shorten them."},
           .truth = exactly("volume-length=0"),
           .inactive = needs_stencil},
          0, 1e6, OptionScale::logarithmic, "world units"),
      toggle<&Settings::volume_depth_clamp>(
          {.key = "volume-depth-clamp",
           .label = "Volume depth clamp",
           .help = {"Keeps the faces of shadow volumes that lie beyond the far limit, as if they lay on it.",
                    "Everitt and Kilgard 2002",
                    "Without, the far limit cuts volumes open, and depth fail misses a face wherever a line of sight "
                    "leaves a volume behind the limit."},
           .truth = exactly("volume-depth-clamp=on"),
           .inactive = needs_cut_volumes}),
      choice<&Settings::self_hit>(
          {.key = "self-hit",
           .label = "Self-hit guard",
           .help = {"How a ray that starts on a surface avoids meeting that surface again.",
                    "CGFS ch. 4; pbrt 6.8; Waechter and Binder, Ray Tracing Gems 6",
                    "With the book's epsilon in float, 5.7 % of the ground's pixels reflect themselves."},
           .truth = exactly("self-hit=offset"),
           .inactive = needs_secondary_rays},
          {{"offset", "bounded offset",
            "Starts outside the bound of the hit point's own rounding error; a sphere leaves its root t = 0 out. No "
            "knob."},
           {"epsilon", "epsilon", "Ignores hits with t up to epsilon, as in the book."},
           {"normal-bump", "normal bump", "Starts epsilon above the surface along its normal, as in CGPP."}}),
      real<&Settings::shadow_epsilon>(
          {.key = "shadow-epsilon",
           .label = "Shadow epsilon",
           .help = {"How far from its start a shadow ray begins to look for blockers.", "CGFS ch. 4",
                    "Too small: acne, surfaces shadow themselves. Too large: shadows come off their objects."},
           .truth = exactly("self-hit=offset"),
           .inactive = needs_shadow_epsilon},
          0, 10, OptionScale::logarithmic),
      choice<&Settings::epsilon_unit>(
          {.key = "epsilon-unit",
           .label = "Epsilon measures",
           .help = {"The unit of both epsilons.", "CGFS ch. 4",
                    "As a ray parameter, 0.001 is 0.0057 units long for the light direction (1, 4, 4)."},
           .truth = exactly("self-hit=offset"),
           .inactive = needs_epsilon},
          {{"ray-parameter", "ray parameter t", "In lengths of the ray's direction, as in the book."},
           {"distance", "distance", "In world units."}}),
      toggle<&Settings::shadow_any_hit>(
          {.key = "shadow-any-hit",
           .label = "Stop at any hit",
           .help = {"A shadow ray ends at the first blocker found instead of searching for the nearest.", "CGFS ch. 5",
                    "Only speed changes."},
           .truth = as_set(),
           .inactive = needs_shadow_rays,
           .effect = OptionEffect::speed}),
      choice<&Settings::shadow_rays>(
          {.key = "shadow-rays",
           .label = "Shadow rays",
           .help = {"To which lights a lit point sends a shadow ray.", "CGFS ch. 4",
                    "The colours stay the same: where a light adds nothing, it does not matter what stands before it. "
                    "Only the picture of shadows no longer marks those points."},
           .truth = as_set(),
           .inactive = needs_shadow_rays},
          {{"all", "to every light", "As in the book: also where the light comes from behind the surface."},
           {"useful", "to lights that add something",
            "Where the light is in front of the surface, or makes a highlight."}}),
  };
}

}  // namespace ps::rows
