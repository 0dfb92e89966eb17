#include "options/rows.h"

namespace ps::rows {

std::vector<Option> reflection_rows() {
  return {
      integer<&Settings::reflection_depth>(
          {.key = "reflection-depth",
           .label = "Reflection depth",
           .help = {"How many bounces a ray may make, refractions included.", "CGFS ch. 4 and 5",
                    "Too few: mirrors in mirrors turn to the surface's own colour."},
           .inactive = [](const Settings& s, const SceneTraits& t) -> Reason {
             if (const auto reason = needs_rays(s, t)) return reason;
             if (!t.reflective && !t.transparent) return "no material of the scene reflects or is transparent";
             return {};
           }},
          0, 64, "bounces"),
      real<&Settings::reflection_epsilon>(
          {.key = "reflection-epsilon",
           .label = "Reflection epsilon",
           .help = {"How far from its start a reflected ray begins to look for surfaces.", "CGFS ch. 4",
                    "The book's 0.001 is too small in float for its own ground sphere of radius 5000."},
           .inactive = [](const Settings& s, const SceneTraits& t) -> Reason {
             if (const auto reason = needs_rays(s, t)) return reason;
             if ((!t.reflective && !t.transparent) || s.reflection_depth == 0) return "no reflected rays";
             if (s.self_hit == SelfHit::offset) return "needs self-hit = epsilon or normal-bump";
             return {};
           }},
          0, 10, OptionScale::logarithmic),
      toggle<&Settings::refraction>(
          {.key = "refraction",
           .label = "Refraction",
           .help = {"Light bends where it enters or leaves a material (Snell's law).", "CGFS ch. 5",
                    "Off: it runs straight on, and glass looks like a thin film."},
           .inactive = [](const Settings& s, const SceneTraits& t) -> Reason {
             if (const auto reason = needs_rays(s, t)) return reason;
             if (!t.transparent) return "no material of the scene is transparent";
             if (s.reflection_depth == 0) return "needs reflection-depth above 0";
             return {};
           }}),
      choice<&Settings::transparency>(
          {.key = "transparency",
           .label = "Transparency",
           .help = {"How light is shared between what a boundary mirrors and what it lets through.",
                    "CGFS ch. 5; Fresnel's equations",
                    "Fixed shares miss that glass mirrors more the flatter one looks at it. Fresnel traces two rays at "
                    "each boundary. In both, what is transparent throws no shadow at all: shadow rays pass it straight "
                    "and unweakened, since the book says nothing of its shadow and the true one is bent light "
                    "(caustics), which no straight ray finds."},
           .inactive = [](const Settings& s, const SceneTraits& t) -> Reason {
             if (const auto reason = needs_rays(s, t)) return reason;
             if (!t.transparent) return "no material of the scene is transparent";
             if (s.reflection_depth == 0) return "needs reflection-depth above 0";
             if (!s.refraction) return "needs refraction = on";
             return {};
           }},
          {{"fixed", "fixed shares", "The material's transparency comes through, whatever the angle."},
           {"fresnel", "Fresnel", "The boundary mirrors a share of it that grows towards flat angles."}}),
  };
}

}  // namespace ps::rows
