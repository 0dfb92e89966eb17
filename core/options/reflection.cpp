#include "options/rows.h"

namespace ps::rows {

std::vector<Option> reflection_rows() {
  return {
      integer<&Settings::reflection_depth>({.key = "reflection-depth",
                                            .label = "Reflection depth",
                                            .help = {"How many bounces a ray may make.", "CGFS ch. 4",
                                                     "Too few: mirrors in mirrors turn to the surface's own colour."},
                                            .inactive = [](const Settings& s, const SceneTraits& t) -> Reason {
                                              if (const auto reason = needs_rays(s, t)) return reason;
                                              if (!t.reflective) return "no material of the scene reflects";
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
             if (!t.reflective || s.reflection_depth == 0) return "no reflected rays";
             if (s.self_hit == SelfHit::offset) return "needs self-hit = epsilon or normal-bump";
             return {};
           }},
          0, 10, OptionScale::logarithmic),
  };
}

}  // namespace ps::rows
