#pragma once
#include <vector>

#include "record/story.h"
#include "scene/scene.h"

namespace ps {

/// One step of two stories beside each other: events of A and B that are about the same thing, or one without a
/// partner.
struct AlignedRow {
  int a = -1, b = -1;  ///< event indices; -1 = the step does not exist there
  int depth = 0;       ///< how many events lie above it
  /// Both are equal to the four digits that people read; an event of a ray and one of a fragment are equal if their
  /// outcomes are.
  bool same = false;
};

/// Puts the events of two stories of one pixel side by side: the trees are walked together, and among the children of a
/// matched pair the longest common sequence of events about the same thing (the same primitive, light or kind of ray)
/// is matched. Rows come in the order in which things happened, A's unmatched before B's. A ray's story beside that of
/// fragments is aligned by what both are about (align_parts.h).
std::vector<AlignedRow> align_stories(const PixelStory& a, const PixelStory& b, const Scene& scene);

}  // namespace ps
