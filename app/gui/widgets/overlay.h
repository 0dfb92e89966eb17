#pragma once
#include <imgui.h>

namespace ps::gui {

/// A window over all others, which a click beside it closes. `just_opened` is set by its opener, so that the
/// click that did so does not count.
class Overlay {
 public:
  Overlay(const char* id, ImVec2 corner, ImVec2 size, ImGuiWindowFlags flags, bool& just_opened);
  /// In the middle, as high as its content; what is in it may have lists that open.
  Overlay(const char* id, float width, bool& just_opened);
  ~Overlay();
  Overlay(const Overlay&) = delete;
  Overlay& operator=(const Overlay&) = delete;

  /// Whether the mouse was pressed beside the window; to be asked after its content was drawn.
  bool left() const;

 private:
  void begin(const char* id, ImGuiWindowFlags flags);

  bool& just_opened_;
};

}  // namespace ps::gui
