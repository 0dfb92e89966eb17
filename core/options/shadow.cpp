#include "options/rows.h"

namespace ps::rows {
namespace {

Reason needs_casting_light(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_rays(s, t)) return reason;
  if (!s.lighting) return "needs lighting = on";
  if (!t.casting_lights) return "the scene has no light that casts shadows";
  return {};
}

Reason needs_shadow_rays(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_casting_light(s, t)) return reason;
  if (s.shadows != Shadows::traced) return "needs shadows = traced";
  return {};
}

Reason needs_secondary_rays(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_rays(s, t)) return reason;
  const bool shadows = s.lighting && t.casting_lights && s.shadows == Shadows::traced;
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
      choice<&Settings::shadows>({.key = "shadows",
                                  .label = "Shadows",
                                  .help = {"Whether a light that cannot be seen from a point lights it.", "CGFS ch. 4",
                                           "Each shadow ray costs about as much as an eye ray."},
                                  .inactive = needs_casting_light},
                                 {{"traced", "traced", "One shadow ray for each light."},
                                  {"none", "none", "All lights shine through everything."}}),
      choice<&Settings::self_hit>(
          {.key = "self-hit",
           .label = "Self-hit guard",
           .help = {"How a ray that starts on a surface avoids meeting that surface again.",
                    "CGFS ch. 4; pbrt 6.8; Waechter and Binder, Ray Tracing Gems 6",
                    "With the book's epsilon in float, 5.7 % of the ground's pixels reflect themselves."},
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
           .inactive = needs_shadow_epsilon},
          0, 10, OptionScale::logarithmic),
      choice<&Settings::epsilon_unit>(
          {.key = "epsilon-unit",
           .label = "Epsilon measures",
           .help = {"The unit of both epsilons.", "CGFS ch. 4",
                    "As a ray parameter, 0.001 is 0.0057 units long for the light direction (1, 4, 4)."},
           .inactive = needs_epsilon},
          {{"ray-parameter", "ray parameter t", "In lengths of the ray's direction, as in the book."},
           {"distance", "distance", "In world units."}}),
      toggle<&Settings::shadow_any_hit>(
          {.key = "shadow-any-hit",
           .label = "Stop at any hit",
           .help = {"A shadow ray ends at the first blocker found instead of searching for the nearest.", "CGFS ch. 5",
                    "Only speed changes."},
           .inactive = needs_shadow_rays,
           .effect = OptionEffect::speed}),
  };
}

}  // namespace ps::rows
