#include "gui/platform/display.h"

#include <SDL.h>

#include <algorithm>

namespace ps::gui {
namespace {

int display_of(SDL_Window* window) { return window ? std::max(SDL_GetWindowDisplayIndex(window), 0) : 0; }

DisplayArea area_of(const SDL_Rect& rect) { return {rect.x, rect.y, {rect.w, rect.h}}; }

}  // namespace

DisplayArea whole_area(SDL_Window* window) {
  SDL_Rect rect{0, 0, 1280, 800};
  SDL_GetDisplayBounds(display_of(window), &rect);
  return area_of(rect);
}

DisplayArea usable_area(SDL_Window* window) {
  SDL_Rect rect{};
  return SDL_GetDisplayUsableBounds(display_of(window), &rect) == 0 ? area_of(rect) : whole_area(window);
}

WindowSize clamped(WindowSize size, WindowSize room) {
  return {std::min(size.width, room.width), std::min(size.height, room.height)};
}

WindowSize opening_size(WindowSize wished) {
  const WindowSize room = usable_area(nullptr).size;
  if (wished == WindowSize{}) return {room.width * 9 / 10, room.height * 9 / 10};
  return clamped(wished, room);
}

}  // namespace ps::gui
