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

}  // namespace ps::gui
