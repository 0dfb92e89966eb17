#pragma once
#include <string>
#include <vector>

#include "record/story.h"
#include "scene/scene.h"

namespace ps::gui {

/// Which event of a story is picked, and which page of a long one is shown.
struct StoryCursor {
  int selected = -1;    ///< index of an event; its numbers are shown below it
  bool reveal = false;  ///< the selected event shall be brought into view
  int page = 0;
};

inline constexpr int events_per_page = 200;

struct PinnedStory;

/// The events as a tree with their numbers; `name` goes before the names of its rows. With `pinned`, what an event was
/// then stands below its row, and its old numbers above the new ones.
void story_tree_view(const std::string& name, const PixelStory& story, const Scene& scene, StoryCursor& cursor,
                     const PinnedStory* pinned = nullptr);

/// The whole story as text, one event a line, for the clipboard.
std::string story_text(const PixelStory& story, const Scene& scene);

}  // namespace ps::gui
