#pragma once
#include <chrono>
#include <optional>

#include "gui/platform/window_size.h"

namespace ps::gui {

/// The size that a window has when it is neither maximised nor full screen nor minimised: what it goes back to, and
/// what the next start opens it with. The system reports a size and a state one after the other, in either order, so a
/// new size counts only once the state has stayed normal for a moment.
class NormalSize {
 public:
  using Time = std::chrono::steady_clock::time_point;
  static constexpr std::chrono::milliseconds moment{500};

  explicit NormalSize(WindowSize size = {}) : size_(size) {}

  /// The window has this size and state at this time.
  void take(WindowSize size, bool normal, Time now) {
    if (newest_ && now - since_ >= moment) size_ = *newest_;
    if (!normal) {
      newest_.reset();
    } else if (newest_ != size) {
      newest_ = size;
      since_ = now;
    }
  }
  WindowSize get() const { return size_; }

 private:
  WindowSize size_;
  std::optional<WindowSize> newest_;  // reported in normal state
  Time since_;
};

}  // namespace ps::gui
