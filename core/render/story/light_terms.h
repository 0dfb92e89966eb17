#pragma once
#include <vector>

#include "record/story.h"
#include "scene/scene.h"

namespace ps {

/// The events that made one surface colour.
struct ShadingEvents {
  int shade = -1;           ///< index of the ShadeEvent
  std::vector<int> lights;  ///< indices of the LightEvents that led to it
  PixelId id;               ///< whose surface it is
};

/// Ledger lines for one surface colour, each scaled by `share`: ambient, diffuse and specular of each light
/// (CGFS ch. 3). Where the lights' terms do not add up to the colour, as when lit corners were interpolated, one line
/// for all light instead. The lines of level `level` add up to share * local colour.
std::vector<LedgerLine> light_terms(const PixelStory& story, const Scene& scene, const ShadingEvents& shading,
                                    double share, int level);

}  // namespace ps
