#pragma once
#include <string>

#include "gui/input/actions.h"

union SDL_Event;

namespace ps::gui {

/// Events that are not mouse or keyboard.
struct WindowEvent {
  bool close = false;
  std::string dropped_file;
};
WindowEvent read_event(const SDL_Event& event);

/// Puts events into SDL's queue as if they came from the devices; for scripts. Coordinates in window pixels.
enum class MouseButton { left, middle, right };
void push_move(unsigned window, float x, float y);
void push_button(unsigned window, MouseButton button, bool down, float x, float y, int clicks);
void push_wheel(unsigned window, float steps);
/// The key itself and, before it goes down and after it came up, its modifiers.
void push_key(unsigned window, const Chord& chord, bool down);
void push_text(unsigned window, const std::string& utf8);
void push_drop(unsigned window, const std::string& path);

}  // namespace ps::gui
