#pragma once

namespace ps::gui {

/// A place in the window, in its pixels from the top left.
struct WindowPoint {
  float x = 0, y = 0;
};

}  // namespace ps::gui
