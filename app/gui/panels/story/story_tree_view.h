#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "record/field_query.h"
#include "record/story.h"
#include "scene/scene.h"

namespace ps::gui {

inline constexpr int events_per_page = 200;

/// State of a tree of events.
struct StoryTreeState {
  int page = 0;                     ///< of a long story
  bool reveal = false;              ///< the selected event shall be brought into view
  int selected = -1;                ///< that was drawn last
  std::optional<FieldQuery> asked;  ///< the number that was clicked, to be shown for every pixel
  std::shared_ptr<const PixelStory> story;

  /// Before it is drawn: an event that was selected elsewhere comes into view; one that is the same event in a newer
  /// story of the pixel stays where it is.
  void follow(const std::shared_ptr<const PixelStory>& now, int selected_now);
};

struct PinnedStory;

/// The events as a tree with their numbers; `name` goes before the names of its rows. After StoryTreeState::follow().
/// With `pinned`, what an event was then is below its row, and its old numbers above the new ones. Answers the
/// event that a click selects, -1 where it takes the selection back.
std::optional<int> story_tree_view(const std::string& name, const PixelStory& story, const Scene& scene,
                                   StoryTreeState& state, const PinnedStory* pinned = nullptr);

/// The whole story as text, one event a line, for the clipboard.
std::string story_text(const PixelStory& story, const Scene& scene);

}  // namespace ps::gui
