#pragma once
#include <imgui.h>

#include <vector>

namespace ps::gui {

/// Remembers what Dear ImGui handed over for the last frame, so that a frame like it need not be drawn again: drivers
/// that draw by the processor take twenty times as long for it as this comparison.
class FrameMemory {
 public:
  /// Whether these are the same triangles in the same order as the last time. Remembers them. Textures are not looked
  /// into.
  bool same_again(const ImDrawData& data);
  /// The next frame counts as another one.
  void forget() { lists_.clear(); }

 private:
  struct List {
    std::vector<ImDrawVert> vertices;
    std::vector<ImDrawIdx> indices;
    std::vector<ImDrawCmd> commands;
  };
  ImVec2 size_{};
  std::vector<List> lists_;
};

}  // namespace ps::gui
