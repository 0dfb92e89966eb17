#pragma once
#include "record/story.h"
#include "scene/scene.h"

namespace ps::parting {

/// The outcome of a triangle, or of all triangles of one object, at a pixel.
struct FragmentFate {
  int event = -1;             ///< its last FragmentEvent, else the RejectEvent that says most; -1 if it never came near
  PixelId winner;             ///< what the pixel shows in the end
  bool painted_over = false;  ///< something drawn later took the pixel
  bool tied_with_winner = false;  ///< and was at nearly the same depth
};

FragmentFate fate_of(const PixelStory& story, const PixelId& id);

/// Whether the rasterizer draws the object as triangles of its own making (spheres and solids).
bool is_tessellated(const Scene& scene, const PixelId& id);

}  // namespace ps::parting
