#pragma once
#include <string>

#include "gui/input/actions.h"
#include "gui/input/event.h"

union SDL_Event;

namespace ps::gui {

/// The event in our own terms.
InputEvent translated(const SDL_Event& event);
/// SDL's number of the key in a place, of the left one of two; 0 for what has no place.
int scancode_of(Key place);
/// The place with that number; Key::other if it has no name here.
Key key_of(int scancode);

/// Puts events into SDL's queue as if they came from the devices; for scripts. Coordinates in window pixels.
void push_move(unsigned window, float x, float y);
void push_button(unsigned window, MouseButton button, bool down, float x, float y, int clicks);
void push_wheel(unsigned window, float steps);
/// The key that gives the chord in the keyboard's layout and, before it goes down and after it came up, its modifiers.
void push_key(unsigned window, const Chord& chord, bool down);
void push_text(unsigned window, const std::string& utf8);
void push_drop(unsigned window, const std::string& path);

}  // namespace ps::gui
