#pragma once
#include <string>
#include <vector>

#include "inspect/story.h"
#include "scene/scene.h"

namespace ps::gui {

/// Which event of a story is picked, and which page of a long one is shown.
struct StoryCursor {
  int selected = -1;    ///< index of an event; its numbers are shown below it
  bool reveal = false;  ///< the selected event shall be brought into view
  int page = 0;
};

inline constexpr int events_per_page = 200;

/// The events as a tree with their numbers; `name` goes before the names of its rows.
void story_tree_view(const std::string& name, const PixelStory& story, const Scene& scene, StoryCursor& cursor);

/// The whole story as text, one event a line, for the clipboard.
std::string story_text(const PixelStory& story, const Scene& scene);

}  // namespace ps::gui
