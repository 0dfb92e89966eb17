#pragma once
#include <array>
#include <functional>
#include <string>

#include "gui/app/session.h"
#include "gui/app/story_tree_view.h"

namespace ps::gui {

/// What the inspector remembers of itself.
struct PixelPanelState {
  enum class Tab { a, b, both } tab = Tab::a;
  std::array<StoryCursor, 2> cursors;
  std::array<std::shared_ptr<const PixelStory>, 2> told;  ///< the stories that the cursors point into
  bool events_open = true, sum_open = true, work_open = false;
};

/// The story of the picked pixel: verdict, events as a tree, the colour as a sum, and the work it took.
/// `copy` puts text on the clipboard.
void pixel_panel(Session& session, PixelPanelState& state, const std::function<void(const std::string&)>& copy);

}  // namespace ps::gui
