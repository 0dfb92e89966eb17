#pragma once
#include <imgui.h>

namespace ps::gui {

/// In which frame something was drawn last.
class Seen {
 public:
  void now() { frame_ = ImGui::GetFrameCount(); }
  /// In this frame or the one before.
  bool lately() const { return frame_ + 1 >= ImGui::GetFrameCount(); }

 private:
  int frame_ = -2;
};

/// Once per frame: stops the estimate of a tab that is no longer seen, which would take the processors from what is. It
/// begins anew when the tab is drawn.
template <class TabState>
void drop_unseen_estimate(TabState& tab) {
  if (!tab.estimate.running() || tab.seen.lately()) return;
  tab.estimate.cancel();
  tab.estimated.clear();
}

}  // namespace ps::gui
