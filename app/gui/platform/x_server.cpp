#include "gui/platform/x_server.h"

#include <SDL.h>
#include <SDL_syswm.h>

#include <algorithm>
#include <vector>

namespace ps::gui {

#ifdef SDL_VIDEO_DRIVER_X11
namespace {

/// The beginning of what XkbGetState writes, which is 18 bytes.
struct KeyboardState {
  unsigned char group = 0;
  unsigned char rest[31] = {};
};

/// Xlib's functions, from the library that SDL itself uses.
struct Xlib {
  decltype(&XDefaultRootWindow) root = nullptr;
  decltype(&XInternAtom) atom = nullptr;
  decltype(&XGetWindowProperty) property = nullptr;
  decltype(&XGetGeometry) geometry = nullptr;
  decltype(&XSetErrorHandler) on_error = nullptr;
  decltype(&XSync) sync = nullptr;
  decltype(&XFree) release = nullptr;
  int (*keyboard_state)(Display*, unsigned device, KeyboardState*) = nullptr;
  KeySym (*symbol)(Display*, KeyCode, int group, int level) = nullptr;

  bool complete() const {
    return root && atom && property && geometry && on_error && sync && release && keyboard_state && symbol;
  }
};

template <typename Function>
void find(void* library, const char* name, Function& function) {
  function = reinterpret_cast<Function>(SDL_LoadFunction(library, name));
}

const Xlib& xlib() {
  static const Xlib found = [] {
    Xlib result;
    void* const library = SDL_LoadObject("libX11.so.6");  // stays loaded
    if (!library) return result;
    find(library, "XDefaultRootWindow", result.root);
    find(library, "XInternAtom", result.atom);
    find(library, "XGetWindowProperty", result.property);
    find(library, "XGetGeometry", result.geometry);
    find(library, "XSetErrorHandler", result.on_error);
    find(library, "XSync", result.sync);
    find(library, "XFree", result.release);
    find(library, "XkbGetState", result.keyboard_state);
    find(library, "XkbKeycodeToKeysym", result.symbol);
    return result;
  }();
  return found;
}

/// A window as Xlib knows it; its display is null on other systems.
struct XWindow {
  Display* display = nullptr;
  ::Window id = 0;
};

XWindow x_window(SDL_Window* window) {
  SDL_SysWMinfo info;
  SDL_VERSION(&info.version);
  if (!SDL_GetWindowWMInfo(window, &info) || info.subsystem != SDL_SYSWM_X11 || !xlib().complete()) return {};
  return {info.info.x11.display, info.info.x11.window};
}

/// The list in a window's property; empty if it has no such property, or if the window is gone.
std::vector<unsigned long> listed(const XWindow& of, const char* name, Atom type) {
  const Xlib& x = xlib();
  const auto previous = x.on_error([](Display*, XErrorEvent*) { return 0; });  // Xlib's own ends the program
  Atom found_type = 0;
  int bits = 0;
  unsigned long count = 0, rest = 0;
  unsigned char* data = nullptr;
  constexpr long longest = 4096;
  const int status = x.property(of.display, of.id, x.atom(of.display, name, False), 0, longest, False, type,
                                &found_type, &bits, &count, &rest, &data);
  x.sync(of.display, False);
  x.on_error(previous);
  std::vector<unsigned long> values;
  if (status == 0 && found_type == type && bits == 32 && data) {  // Xlib keeps 32 bits in a long
    const auto* const first = reinterpret_cast<const unsigned long*>(data);
    values.assign(first, first + count);
  }
  if (data) x.release(data);
  return values;
}

}  // namespace

bool window_manager_helps(SDL_Window* window) {
  const XWindow own = x_window(window);
  if (!own.display) return true;
  // Extended Window Manager Hints: the root names a window of the manager, which names itself. One that has ended
  // leaves the root's property behind.
  constexpr Atom type_atom = 4, type_window = 33;  // XA_ATOM, XA_WINDOW
  const XWindow root{own.display, xlib().root(own.display)};
  const auto manager = listed(root, "_NET_SUPPORTING_WM_CHECK", type_window);
  if (manager.size() != 1 || listed({own.display, manager[0]}, "_NET_SUPPORTING_WM_CHECK", type_window) != manager)
    return false;
  const auto offered = listed(root, "_NET_SUPPORTED", type_atom);
  const Atom full_screen = xlib().atom(own.display, "_NET_WM_STATE_FULLSCREEN", False);
  return std::find(offered.begin(), offered.end(), full_screen) != offered.end();
}

std::optional<WindowSize> size_on_server(SDL_Window* window) {
  const XWindow own = x_window(window);
  if (!own.display) return {};
  ::Window root = 0;
  int x = 0, y = 0;
  unsigned width = 0, height = 0, border = 0, depth = 0;
  if (!xlib().geometry(own.display, own.id, &root, &x, &y, &width, &height, &border, &depth)) return {};
  return WindowSize{static_cast<int>(width), static_cast<int>(height)};
}

int layout_in_use(SDL_Window* window) {
  const XWindow own = x_window(window);
  constexpr unsigned core_keyboard = 0x0100;  // XkbUseCoreKbd
  KeyboardState state;
  if (own.display) xlib().keyboard_state(own.display, core_keyboard, &state);
  return state.group;
}

std::optional<unsigned long> symbol_on_key(SDL_Window* window, int number, int layout, int level) {
  const XWindow own = x_window(window);
  if (!own.display) return {};
  return xlib().symbol(own.display, static_cast<KeyCode>(number), layout, level);
}
#else
bool window_manager_helps(SDL_Window*) { return true; }
std::optional<WindowSize> size_on_server(SDL_Window*) { return {}; }
int layout_in_use(SDL_Window*) { return 0; }
std::optional<unsigned long> symbol_on_key(SDL_Window*, int, int, int) { return {}; }
#endif

}  // namespace ps::gui
