#pragma once
#include "gui/panels/options/work_log.h"
#include "gui/session/session.h"
#include "gui/work/thumbnails.h"

namespace ps::gui {

/// State of the list of steps.
struct HistoryPanelState {
  explicit HistoryPanelState(std::function<void()> wake) : thumbnails(std::move(wake)) {}
  bool open = false;
  Thumbnails thumbnails;
  WorkLog log;
  std::size_t shown_place = 0;  ///< the step that was last scrolled to
  std::size_t shown_count = 0;
};

/// Every step of the history with small pictures of A and B, oldest first; a click goes there. Steps that were undone
/// stay in the list until another change takes their place.
void history_panel(Session& session, HistoryPanelState& state);

}  // namespace ps::gui
