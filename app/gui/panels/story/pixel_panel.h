#pragma once
#include <array>
#include <functional>
#include <string>
#include <utility>

#include "gui/panels/pictures/canvas_rows_view.h"
#include "gui/panels/story/parting_view.h"
#include "gui/panels/story/pin_view.h"
#include "gui/panels/story/story_tree_view.h"
#include "gui/session/session.h"

namespace ps::gui {

/// State of the inspector.
struct PixelPanelState {
  /// `wake` as for PinState.
  explicit PixelPanelState(const std::function<void()>& wake) : pin(wake) {}

  std::array<StoryTreeState, 2> trees;
  PartingViewState parting;
  PinState pin;
  bool events_open = true, sum_open = true, work_open = false, rows_open = false;
  CanvasRowsState rows;
  std::array<bool, 2> both_events_open{false, false}, both_sum_open{true, true};  ///< in the view of both
};

/// The story of the picked pixel: verdict, events as a tree, the colour as a sum, and the work it took.
/// `copy` puts text on the clipboard.
void pixel_panel(Session& session, PixelPanelState& state, const std::function<void(const std::string&)>& copy);

}  // namespace ps::gui
