#pragma once
#include "gui/base/seen.h"

namespace ps::gui {

/// Once per frame: stops the estimate of a tab that is no longer seen, which would take the processors from what is. It
/// begins anew when the tab is drawn.
template <class TabState>
void drop_unseen_estimate(TabState& tab) {
  if (!tab.estimate.running() || tab.seen.lately()) return;
  tab.estimate.cancel();
  tab.estimated.clear();
}

}  // namespace ps::gui
