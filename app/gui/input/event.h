#pragma once
#include <string>

#include "gui/base/window_point.h"
#include "gui/input/key.h"

namespace ps::gui {

enum class MouseButton { left, right, middle, back, forward };

/// Something that a person did, or that became of the window. platform/events.h makes them of what the system reports.
struct InputEvent {
  enum class Kind {
    move,        ///< of the pointer, to `at`
    leave,       ///< the pointer left the window
    button,      ///< `button` went `down` or up, at `at`
    wheel,       ///< by `at` steps, rightwards and away from the person
    key,         ///< the key in the place `key` went `down` or up
    text,        ///< `text` was typed
    focus_lost,  ///< the keyboard belongs to another window
    drop,        ///< the file `text` was dropped
    close,       ///< the window is to be closed
    other        ///< the window changed, for example its size, or must be drawn again
  };
  Kind kind = Kind::other;
  WindowPoint at;
  MouseButton button = MouseButton::left;
  Key key = Key::none;
  bool down = false, repeat = false;
  bool ctrl = false, shift = false, alt = false;  ///< held together with a key
  bool right_alt = false;                         ///< likewise; in many layouts it is AltGr
  std::string text = {};                          ///< UTF-8
};

}  // namespace ps::gui
