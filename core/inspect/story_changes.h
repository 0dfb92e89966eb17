#pragma once
#include <optional>
#include <string>
#include <vector>

#include "record/story.h"
#include "scene/scene.h"

namespace ps {

/// The changes of a pixel's numbers between two of its stories: one that was pinned and a later one, after an option or
/// the scene changed.

/// A number or word of an event, then and now; the text is empty where the event did not have it.
struct FieldChange {
  std::string name;  ///< "shading normal"
  std::string before, after;
  std::string exact_before, exact_after;
  bool changed = false;  ///< in any digit
};

/// An event of either story, with its partner in the other.
struct StepChange {
  int before = -1, after = -1;  ///< event indices; -1 = there is none
  int depth = 0;
  bool changed = false;
  std::string text;  ///< of the later event, or of the one that is gone
  std::vector<FieldChange> fields;
};

/// A line of the sum; a value is absent where the sum did not have the line.
struct LedgerChange {
  int level = 0;
  std::string term;  ///< of the later line, or of the one that is gone
  std::optional<Vec3d> before, after;
  int event = -1;  ///< of the later story
  bool changed() const { return before != after; }
};

struct StoryChanges {
  std::vector<StepChange> steps;  ///< in the order of align_stories()
  std::vector<LedgerChange> ledger;
  Vec3d linear_before{0, 0, 0}, linear_after{0, 0, 0};
  std::array<int, 3> display_before{}, display_after{};
  int changed_steps = 0;
};

/// Both stories must be of the same renderer for their steps to be comparable; others still give a list of what came
/// and went. Names come from `scene`.
StoryChanges story_changes(const PixelStory& before, const PixelStory& after, const Scene& scene);

}  // namespace ps
