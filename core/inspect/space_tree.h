#pragma once
#include <cstddef>

#include "frame/prepared.h"
#include "inspect/space_model.h"

namespace ps {

/// An accelerator in numbers.
struct SpaceTree {
  std::size_t nodes = 0;       ///< of all levels; empty cells of an octree left out
  std::size_t primitives = 0;  ///< that it holds
  std::size_t entries = 0;     ///< how often its leaves list them together: more where one is in several cells
};

/// More nodes in one drawing show nothing.
inline constexpr std::size_t most_drawn_nodes = 2000;

/// Adds to the model the nodes of the ray tracer's accelerator that no ray of `story` came to, level by level from the
/// root, until there are `most`. Of two levels of trees the upper one, with a box for each instance; nothing without a
/// tree, and of Embree's, which shows none. The tree lies in `prepared`, where the picture has left it, or is built
/// there. Throws Cancelled (base/stop.h).
SpaceTree add_tree(const Scene& scene, const Settings& settings, const PixelStory* story, Prepared& prepared,
                   SpaceModel& model, std::size_t most = most_drawn_nodes);

}  // namespace ps
