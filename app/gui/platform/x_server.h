#pragma once
#include <optional>

#include "gui/platform/window_size.h"

struct SDL_Window;

namespace ps::gui {

/// Whether windows can be made full screen and maximised by asking: whether a window manager runs that offers it. On
/// systems other than X11, true.
bool window_manager_helps(SDL_Window* window);

/// The size that the window has on the X server, which SDL 2 does not ask for: it takes its own wish for granted, also
/// where nobody fulfils it. nullopt on systems other than X11.
std::optional<WindowSize> size_on_server(SDL_Window* window);

/// Which of the layouts that the keyboard switches between is in use, from 0. On systems other than X11, 0.
int layout_in_use(SDL_Window* window);

/// What a key types in a layout, a `keysym` of X11: 0 for none. The key is by its number on PC keyboards, the level
/// 0 for itself, 1 with Shift, 2 with AltGr, 3 with both. nullopt on systems other than X11.
std::optional<unsigned long> symbol_on_key(SDL_Window* window, int number, int layout, int level);

}  // namespace ps::gui
