#pragma once

namespace ps::gui {

/// In the units of the desktop: pixels, but where it scales windows.
struct WindowSize {
  int width = 0, height = 0;
  bool operator==(const WindowSize&) const = default;
};

}  // namespace ps::gui
