#include "options/rows.h"

namespace ps::rows {
namespace {

Reason needs_mirrors(const Settings& s, const SceneTraits& t) {
  if (!t.reflective) return "no material of the scene reflects";
  if (!fills(s.draw)) return needs("draw", Draw::filled);
  return {};
}

/// Some material spawns secondary rays.
Reason needs_bouncing_rays(const Settings&, const SceneTraits& t) {
  if (!t.reflective && !t.transparent) return "no material of the scene reflects or is transparent";
  return {};
}

}  // namespace

std::vector<Option> reflection_rows() {
  return {
      integer<&Settings::reflection_depth>(
          {.key = "reflection-depth",
           .label = "Reflection depth",
           .help = {"Maximum number of bounces of a ray, refractions included.", "CGFS ch. 4 and 5",
                    "Too small: mirrors seen in mirrors show their local colour."},
           .keywords = "recursion, recursion limit, bounces, mirror, ray depth",
           .truth = exactly("reflection-depth=64"),
           .acts_for = ActsFor::rays,
           .inactive = needs_bouncing_rays,
           .known_to = {.fast = {limit(every_hit, 30, "reflective surfaces are shaded one hit at a time",
                                       [](const Settings& s, const SceneTraits& t) {
                                         return s.reflection_depth > 0 && t.reflective;
                                       })},
                        .hardware = not_asked},
           .shown_by = {.experiments = {{"recursion-depth",
                                         [](const Settings& s) {
                                           return s.reflection_depth > 0 && s.reflection_depth < 3;
                                         },
                                         "reflection-depth=8"}},
                        .scenes = {{"cgfs/reflections"}}}},
          0, 64, "bounces"),
      real<&Settings::reflection_cutoff>(
          {.key = "reflection-cutoff",
           .label = "Minimum contribution",
           .help = {"A bounce that contributes less than this fraction of the pixel's colour is not followed: the "
                    "surface shows its local colour.",
                    "Hall and Greenberg, IEEE CG&A 1983 (adaptive depth control)",
                    "Too large: weak reflections disappear. 0 follows every bounce up to the depth."},
           .keywords = "adaptive depth, threshold, recursion, bounces, ray tree",
           .truth = exactly("reflection-cutoff=0"),
           .acts_for = ActsFor::rays,
           .inactive = [](const Settings& s, const SceneTraits& t) -> Reason {
             if (const auto reason = needs_bouncing_rays(s, t)) return reason;
             if (s.reflection_depth == 0)
               return needs("reflection-depth", Settings{}.reflection_depth).said("needs reflection-depth above 0");
             return {};
           },
           .known_to = {.fast = any_value, .hardware = not_asked},
           .shown_by = {.experiments = none, .scenes = {{"cgfs/reflections"}}}},
          0, 1, OptionScale::linear),
      real<&Settings::reflection_epsilon>(
          {.key = "reflection-epsilon",
           .label = "Reflection epsilon",
           .help = {"Distance from its origin at which a reflected ray starts to search.", "CGFS ch. 4",
                    "Too small: reflected acne; in float the book's 0.001 is too small for its own ground sphere of "
                    "radius 5000."},
           .keywords = "acne, self-intersection, bias, mirror",
           .truth = exactly("self-hit=offset"),
           .acts_for = ActsFor::rays,
           .inactive = [](const Settings& s, const SceneTraits& t) -> Reason {
             if (const auto reason = needs_bouncing_rays(s, t)) return reason;
             if (s.reflection_depth == 0)
               return needs("reflection-depth", Settings{}.reflection_depth).said("needs reflection-depth above 0");
             if (s.self_hit == SelfHit::offset || s.self_hit == SelfHit::exclusion)
               return needs("self-hit", SelfHit::epsilon, SelfHit::normal_bump);
             return {};
           },
           .known_to = {.fast = any_value, .hardware = not_asked},
           .shown_by = {.experiments = {{"reflection-self-hit", is<&Settings::self_hit, SelfHit::epsilon>,
                                         "self-hit=offset", "shadows=none"}},
                        .scenes = {{"cgfs/reflections", "self-hit=epsilon"}}}},
          0, 10, OptionScale::logarithmic),
      toggle<&Settings::refraction>(
          {.key = "refraction",
           .label = "Refraction",
           .help = {"Bends light where it enters or leaves a material (Snell's law).", "CGFS ch. 5",
                    "Off: light passes straight through, and glass looks like a thin film."},
           .keywords = "glass, Snell, transparency, lens, bending",
           .truth = exactly("refraction=on"),
           .acts_for = ActsFor::rays,
           .inactive = [](const Settings& s, const SceneTraits& t) -> Reason {
             if (!t.transparent) return "no material of the scene is transparent";
             if (s.reflection_depth == 0)
               return needs("reflection-depth", Settings{}.reflection_depth).said("needs reflection-depth above 0");
             return {};
           },
           .known_to = {.fast = any_value, .hardware = not_asked},
           .shown_by = {.experiments = {{"refraction-total-internal"}}, .scenes = {{"cgfs/magnifying-glass"}}}}),
      choice<&Settings::transparency>(
          {.key = "transparency",
           .label = "Transparency",
           .help = {"How light is divided between reflection and transmission at a boundary.",
                    "CGFS ch. 5; Fresnel's equations",
                    "Fixed shares ignore the viewing angle; Fresnel traces two rays at each boundary. Transparent "
                    "objects cast no shadows."},
           .keywords = "Fresnel, glass, transmission, opacity",
           .truth = exactly("transparency=fresnel"),
           .acts_for = ActsFor::rays,
           .inactive = [](const Settings& s, const SceneTraits& t) -> Reason {
             if (!t.transparent) return "no material of the scene is transparent";
             if (s.reflection_depth == 0)
               return needs("reflection-depth", Settings{}.reflection_depth).said("needs reflection-depth above 0");
             if (!s.refraction) return needs("refraction", true);
             return {};
           },
           .known_to = {.fast = any_value, .hardware = not_asked},
           .shown_by = {.experiments = {{"refraction-total-internal"}}, .scenes = {{"cgfs/magnifying-glass"}}}},
          {{"fixed", "fixed shares", "The material's transparency is transmitted at every angle."},
           {"fresnel", "Fresnel", "The reflected share grows towards grazing angles."}}),
      choice<&Settings::environment>(
          {.key = "environment",
           .label = "Environment mapping",
           .help = {"How the rasterizer shows reflections: it looks up the reflected "
                    "direction in a cube map of the surroundings.",
                    "CGFS ch. 15",
                    "A cube map is exact only at its centre: near objects and flat mirrors "
                    "show the wrong place, and no object reflects itself."},
           .keywords = "reflection map, cube map, skybox, mirror, environment mapping",
           .truth = averaged_by_rays(),
           .acts_for = ActsFor::fragments,
           .inactive = needs_mirrors,
           .known_to = {.fast = {knows(fragment_batches, 130, Environment::none)
                                     .where(&SceneTraits::reflective)
                                     .said("SIMD does not support environment maps")},
                        .hardware = any_value},
           .shown_by = {.experiments = none, .scenes = {{"lab/mirror-room", "environment-size=32"}}}},
          {{"none", "none", "Mirrors show their local colour."},
           {"cube-map", "cube map for each object",
            "Rendered from the object's centre, again whenever something moves."},
           {"room-map", "one map of the room",
            "Rendered once from the centre of the non-reflective objects. Mirrors do not "
            "appear in it and may move without a new map; the error then grows."}}),
      choice<&Settings::environment_objects>(
          {.key = "environment-objects",
           .label = "Objects in environment maps",
           .help =
               {"Which objects environment maps show. Objects that a scene marks with dynamic = on can be left out: "
                "a map is then made once, and stays right for all others while those move.",
                "CGFS ch. 15", "What is left out is not reflected, however near it is."},
           .keywords = "dynamic, static, cube map, reflection map",
           .truth = averaged_by_rays(),
           .acts_for = ActsFor::fragments,
           .inactive = [](const Settings& s, const SceneTraits& t) -> Reason {
             if (const auto reason = needs_mirrors(s, t)) return reason;
             if (s.environment == Environment::none)
               return needs("environment", Environment::cube_map, Environment::room_map);
             if (!t.dynamic) return "no object of the scene is dynamic";
             return {};
           },
           .known_to = {.fast = any_value, .hardware = any_value},
           .shown_by = {.experiments = none, .scenes = {{"lab/mirror-room", "environment-size=32"}}}},
          {{"all", "all", "Every map is rendered again whenever anything moves that it shows."},
           {"static", "static ones",
            "Rendered again only when a static object, the map's own mirror or the light changes."}}),
      integer<&Settings::environment_size>(
          {.key = "environment-size",
           .label = "Environment map size",
           .help = {"Pixels along each side of a cube map's face.", "CGFS ch. 15",
                    "Too small: blurred reflections. Too large: memory and time for six pictures per map."},
           .keywords = "cube map, resolution, reflection map",
           .truth = exactly("environment-size=1024"),
           .acts_for = ActsFor::fragments,
           .inactive = [](const Settings& s, const SceneTraits& t) -> Reason {
             if (const auto reason = needs_mirrors(s, t)) return reason;
             if (s.environment == Environment::none)
               return needs("environment", Environment::cube_map, Environment::room_map);
             return {};
           },
           .known_to = {.fast = any_value, .hardware = any_value},
           .shown_by = {.experiments = none, .scenes = {{"lab/mirror-room", "environment-size=32"}}}},
          8, 1024, "px"),
  };
}

}  // namespace ps::rows
