#pragma once
#include <optional>
#include <string>
#include <vector>

#include "base/progress.h"
#include "frame/prepared.h"
#include "frame/view.h"
#include "options/settings.h"
#include "scene/scene.h"

namespace ps {

/// What a pixel of the picture shows.
struct SeenPixel {
  Vec2i pixel{0, 0};         ///< array position
  std::string seen;          ///< "red", "triangle 7 of cube 1", "the background"
  std::vector<int> blocked;  ///< lights that do not reach the visible point
};

/// A pixel that shows something else than a neighbour to its left, right, above or below.
struct NearestEdge {
  Vec2i pixel{0, 0};
  std::string here, beyond;  ///< what it shows and what the neighbour does; equal where only a shadow ends
};

/// Around a pixel in which nothing happens.
struct PixelSurroundings {
  std::vector<SeenPixel> around;    ///< the pixel and its up to eight neighbours, row by row
  std::optional<NearestEdge> edge;  ///< the nearest to the pixel, in a straight line; nothing within `searched`
  int searched = 0;                 ///< pixels to each side that were looked at
};

/// Looks around a pixel of the view, with the one sample that a pixel has without supersampling. Objects, triangles and
/// shadows count as different; what is drawn on the canvas does not. Throws Cancelled. nullopt for renderers that do
/// not say what a pixel shows.
std::optional<PixelSurroundings> look_around(const Scene& scene, const View& view, const Settings& settings,
                                             Vec2i pixel, Prepared& prepared, Progress& progress);

}  // namespace ps
