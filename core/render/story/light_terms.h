#pragma once
#include <vector>

#include "record/story.h"
#include "scene/scene.h"

namespace ps {

/// The events that made one surface colour.
struct ShadingEvents {
  int shade = -1;           ///< index of the ShadeEvent
  std::vector<int> lights;  ///< indices of the LightEvents that led to it
  std::vector<int> points;  ///< of the VertexLightEvents that hold them, where the light was computed elsewhere
  PixelId id;               ///< whose surface it is
};

/// "vertex 1" or "centre of the triangle"
std::string point_name(const VertexLightEvent& point);

/// The part of the light of VertexLightEvent `index` that is highlight, by what its lights reported; where the material
/// has a specular colour of its own, times that colour.
Vec3d highlight_of_point(const PixelStory& story, const Scene& scene, int index);

/// Ledger lines for one surface colour, each scaled by `share`: ambient, diffuse and specular of each light
/// (CGFS ch. 3). Where the light was computed at the vertices of a triangle or at its centre (CGFS ch. 13), one line
/// for each of these points, with its weight, and the lights' terms below it. Where the terms do not add up to the
/// colour, one line for all light instead. The lines of level `level` add up to share * local colour.
std::vector<LedgerLine> light_terms(const PixelStory& story, const Scene& scene, const ShadingEvents& shading,
                                    double share, int level);

}  // namespace ps
