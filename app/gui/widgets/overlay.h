#pragma once
#include <imgui.h>

namespace ps::gui {

/// A window over all others, which a click beside it closes. `just_opened` is set by its opener, so that the
/// click that did so does not count.
class Overlay {
 public:
  /// In the middle, as large as the window lets it be, at most `largest` at scale 1. With a height of 0 it is as high
  /// as its content, which may have lists that open.
  Overlay(const char* id, ImVec2 largest, bool& just_opened);
  ~Overlay();
  Overlay(const Overlay&) = delete;
  Overlay& operator=(const Overlay&) = delete;

  /// Whether the mouse was pressed beside the window; to be asked after its content was drawn.
  bool left() const;

 private:
  bool& just_opened_;
};

/// As large as the window lets an overlay be.
inline const ImVec2 whole_window{1e5f, 1e5f};

/// The title of an overlay, and at the right end of its line "close". Answers whether that was clicked.
bool overlay_title(const char* title);
/// "close" at the right end of the line that was begun.
bool close_at_end();

}  // namespace ps::gui
