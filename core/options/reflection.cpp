#include "options/rows.h"

namespace ps::rows {
namespace {

Reason needs_mirrors(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_fragments(s, t)) return reason;
  if (!t.reflective) return "no material of the scene reflects";
  if (s.draw != Draw::filled) return "needs draw = filled";
  return {};
}

/// Something that sends further rays on.
Reason needs_bouncing_rays(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_rays(s, t)) return reason;
  if (!t.reflective && !t.transparent) return "no material of the scene reflects or is transparent";
  return {};
}

}  // namespace

std::vector<Option> reflection_rows() {
  return {
      integer<&Settings::reflection_depth>(
          {.key = "reflection-depth",
           .label = "Reflection depth",
           .help = {"How many bounces a ray may make, refractions included.", "CGFS ch. 4 and 5",
                    "Too few: mirrors in mirrors turn to the surface's own colour."},
           .truth = exactly("reflection-depth=64"),
           .inactive = needs_bouncing_rays},
          0, 64, "bounces"),
      real<&Settings::reflection_cutoff>(
          {.key = "reflection-cutoff",
           .label = "Least share of a bounce",
           .help = {"A bounce that would bring less than this share of the pixel's colour is not followed: the surface "
                    "shows its own colour, as at the greatest depth.",
                    "Hall and Greenberg, IEEE CG&A 1983 (adaptive depth control)",
                    "Too large: weak mirrors mirror nothing. 0 follows every bounce up to the depth."},
           .truth = exactly("reflection-cutoff=0"),
           .inactive = [](const Settings& s, const SceneTraits& t) -> Reason {
             if (const auto reason = needs_bouncing_rays(s, t)) return reason;
             if (s.reflection_depth == 0) return "needs reflection-depth above 0";
             return {};
           }},
          0, 1, OptionScale::linear),
      real<&Settings::reflection_epsilon>(
          {.key = "reflection-epsilon",
           .label = "Reflection epsilon",
           .help = {"How far from its start a reflected ray begins to look for surfaces.", "CGFS ch. 4",
                    "The book's 0.001 is too small in float for its own ground sphere of radius 5000."},
           .truth = exactly("self-hit=offset"),
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
           .truth = exactly("refraction=on"),
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
                    "each boundary. In both, what is transparent casts no shadow at all: shadow rays pass it straight "
                    "and unweakened, since the book says nothing of its shadow and the true one is bent light "
                    "(caustics), which no straight ray finds."},
           .truth = exactly("transparency=fresnel"),
           .inactive = [](const Settings& s, const SceneTraits& t) -> Reason {
             if (const auto reason = needs_rays(s, t)) return reason;
             if (!t.transparent) return "no material of the scene is transparent";
             if (s.reflection_depth == 0) return "needs reflection-depth above 0";
             if (!s.refraction) return "needs refraction = on";
             return {};
           }},
          {{"fixed", "fixed shares", "The material's transparency comes through, whatever the angle."},
           {"fresnel", "Fresnel", "The boundary mirrors a share of it that grows towards flat angles."}}),
      choice<&Settings::environment>(
          {.key = "environment",
           .label = "Environment mapping",
           .help =
               {"How the rasterizer shows what a surface mirrors: it looks the mirrored direction up in six pictures "
                "that it made of the surroundings.",
                "CGFS ch. 15",
                "A map is right only at the point it was made from: near things and flat mirrors show the wrong "
                "place, and an object never mirrors itself."},
           .truth = exactly("renderer=ray-tracer"),
           .inactive = needs_mirrors},
          {{"none", "none", "Mirrors show their own colour."},
           {"cube-map", "cube map for each object", "Made at the object's centre, again whenever something moves."},
           {"room-map", "one map of the room",
            "Made once in the middle of all that mirrors nothing; mirrors are not seen in it, and may move without a "
            "new "
            "one, with an error that grows."}}),
      choice<&Settings::environment_objects>(
          {.key = "environment-objects",
           .label = "Objects in environment maps",
           .help = {"Which objects the cube map of a mirror shows. Objects that a scene marks with dynamic = on can be "
                    "left out: the map is then made once, and stays right for all others while those move.",
                    "CGFS ch. 15", "What is left out is not mirrored, however near it is."},
           .truth = exactly("renderer=ray-tracer"),
           .inactive = [](const Settings& s, const SceneTraits& t) -> Reason {
             if (const auto reason = needs_mirrors(s, t)) return reason;
             if (s.environment != Environment::cube_map) return "needs environment = cube-map";
             if (!t.dynamic) return "no object of the scene is dynamic";
             return {};
           }},
          {{"all", "all", "Six pictures for each mirror, again whenever anything moves."},
           {"static", "static ones", "Made again only when a static object, a mirror or the light changes."}}),
      integer<&Settings::environment_size>(
          {.key = "environment-size",
           .label = "Environment map size",
           .help = {"Pixels along an edge of a cube map.", "CGFS ch. 15",
                    "Small ones blur what is mirrored; large ones cost memory, and six pictures each."},
           .truth = exactly("environment-size=1024"),
           .inactive = [](const Settings& s, const SceneTraits& t) -> Reason {
             if (const auto reason = needs_mirrors(s, t)) return reason;
             if (s.environment == Environment::none) return "needs environment = cube-map or room-map";
             return {};
           }},
          8, 1024, "px"),
  };
}

}  // namespace ps::rows
