#pragma once
#include <optional>

#include "gui/platform/window_size.h"

struct SDL_Window;

namespace ps::gui {

/// Whether windows can be made full screen and maximised by asking: whether a window manager runs that offers it. On
/// systems other than X11, true.
bool window_manager_helps(SDL_Window* window);

/// The size that the window has on the X server, which SDL 2 does not ask for: it takes its own wish for granted, also
/// where nobody fulfils it. Nothing on systems other than X11.
std::optional<WindowSize> size_on_server(SDL_Window* window);

}  // namespace ps::gui
