#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "document/document.h"
#include "gui/base/window_point.h"
#include "math/vec.h"

namespace ps::gui {

/// What the shell shows in its window and what scripts act upon. All members are called on the main thread.
class Content {
 public:
  virtual ~Content() = default;

  /// Draws one frame with Dear ImGui; called between NewFrame and Render.
  virtual void draw() = 0;
  /// Work is going on whose end will change the window (renders, loading). Scripts wait for its end. The thread that
  /// does the work calls Shell::wake() when there is something new to draw.
  virtual bool busy() const = 0;
  /// Wants the next frame although no event arrived (an animation is running).
  virtual bool animating() const { return false; }
  /// Opens a scene file or a built-in scene by name. Errors are shown in the window, not thrown.
  virtual void open(const std::string& path_or_name) = 0;
  /// A file was dropped on the window, at this position, or at the pointer's last position if it is unknown.
  virtual void drop(const std::string& path, std::optional<WindowPoint> at) {
    (void)at;
    open(path);
  }
  /// Sets "key=value" on one side, as a panel would (undoable). Throws InputError for an unknown key or value.
  virtual void set_option(Side side, const std::string& assignment) = 0;
  /// Where the centre of a picture's pixel (array position) is on screen now; nullopt if it is not visible.
  virtual std::optional<WindowPoint> pixel_place(Side side, Vec2i pixel) const = 0;
  /// The user asks to close the window. Answers whether it may close now.
  virtual bool may_close() { return true; }
  /// A logout or a shutdown ends the program, not the user: what is open is to be there again at the next start.
  virtual void ended_from_outside() {}
  /// Shows a sentence that the user should read.
  virtual void warn(const std::string& sentence) { (void)sentence; }
};

}  // namespace ps::gui
