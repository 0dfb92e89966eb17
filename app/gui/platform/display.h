#pragma once
#include "gui/platform/window_size.h"

struct SDL_Window;

namespace ps::gui {

/// A part of the desktop.
struct DisplayArea {
  int x = 0, y = 0;
  WindowSize size;
};

/// The display that a window is on, or the first one for null: all of it, and without panels and docks.
DisplayArea whole_area(SDL_Window* window);
DisplayArea usable_area(SDL_Window* window);

/// No larger than `room`, either way.
WindowSize clamped(WindowSize size, WindowSize room);
/// The size with which a window opens: as wished if that fits, 90 % of the first display for {0, 0}.
WindowSize opening_size(WindowSize wished);

}  // namespace ps::gui
