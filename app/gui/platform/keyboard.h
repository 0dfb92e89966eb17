#pragma once

struct SDL_Window;

namespace ps::gui {

/// Makes keyboard_layout() what the keyboard types: from the X server, or, where there is none, what SDL knows of keys
/// without Shift, which then type with Shift what they type on a US keyboard if they are the same without.
void read_keyboard(SDL_Window* window);
/// The same if the keyboard has switched to another one of its layouts, which SDL does not report.
void follow_keyboard(SDL_Window* window);

}  // namespace ps::gui
