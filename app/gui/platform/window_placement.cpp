// Where the window is, how large, and what it looks like at the next start.
#include <SDL.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "gui/platform/display.h"
#include "gui/platform/window.h"
#include "gui/platform/x_server.h"

namespace ps::gui {
namespace {

bool has_flag(SDL_Window* window, Uint32 flag) { return (SDL_GetWindowFlags(window) & flag) != 0; }

}  // namespace

/// Shows the window that was made hidden.
void Window::open(const WindowPlacement& placement) {
  const bool helped = window_manager_helps(window_);
  if (placement.maximised && helped) SDL_MaximizeWindow(window_);
  SDL_ShowWindow(window_);
  if (placement.maximised && !helped) {
    covers_ = true;
    cover_display();
  }
  opening_ = helped;
  opened_ = std::chrono::steady_clock::now();
  measure();
}

/// A frame and a title around the window must not push its lower edge out of the display. The window manager adds them
/// some time after the window is shown.
void Window::leave_room_for_decoration() {
  constexpr std::chrono::seconds long_enough{2};
  if (!opening_ || !normal()) return;
  if (std::chrono::steady_clock::now() - opened_ > long_enough) opening_ = false;
  int top = 0, left = 0, bottom = 0, right = 0;
  if (SDL_GetWindowBordersSize(window_, &top, &left, &bottom, &right) != 0) return;
  if (top == 0 && left == 0 && bottom == 0 && right == 0) return;
  opening_ = false;
  const DisplayArea area = usable_area(window_);
  const Place now = place();
  const WindowSize room{area.size.width - left - right, area.size.height - top - bottom};
  if (now.size.width <= room.width && now.size.height <= room.height) return;
  move_to({area.x + left, area.y + top, clamped(now.size, room)});
}

Window::Place Window::place() const {
  Place result;
  SDL_GetWindowPosition(window_, &result.x, &result.y);
  SDL_GetWindowSize(window_, &result.size.width, &result.size.height);
  return result;
}

void Window::move_to(const Place& place) {
  SDL_SetWindowSize(window_, place.size.width, place.size.height);
  SDL_SetWindowPosition(window_, place.x, place.y);
}

void Window::cover_display() {
  const DisplayArea area = whole_area(window_);
  move_to({area.x, area.y, area.size});
}

/// Takes over the size that the window really has.
void Window::measure() {
  SDL_GetWindowSize(window_, &size_.width, &size_.height);
  SDL_GetWindowSizeInPixels(window_, &drawable_.width, &drawable_.height);
  // X11 knows no other units than pixels.
  if (const auto real = size_on_server(window_)) size_ = drawable_ = *real;
}

void Window::note_size() { normal_size_.take(place().size, normal(), std::chrono::steady_clock::now()); }

void Window::resize(WindowSize size) {
  const DisplayArea area = usable_area(window_);
  Place next = place();
  next.size = clamped(size, area.size);
  next.x = std::clamp(next.x, area.x, area.x + area.size.width - next.size.width);
  next.y = std::clamp(next.y, area.y, area.y + area.size.height - next.size.height);
  covers_ = false;
  move_to(next);
}

std::array<int, 2> Window::position() const {
  const Place now = place();
  return {now.x, now.y};
}

int Window::display_lines() const { return whole_area(window_).size.height; }

bool Window::visible() const { return !has_flag(window_, SDL_WINDOW_MINIMIZED | SDL_WINDOW_HIDDEN); }

bool Window::normal() const { return visible() && !fullscreen() && !maximised(); }

bool Window::maximised() const {
  return fullscreen() ? was_maximised_ : covers_ || has_flag(window_, SDL_WINDOW_MAXIMIZED);
}

void Window::set_fullscreen(bool on) {
  if (on == fullscreen()) return;
  if (on) {
    was_maximised_ = maximised();
    before_ = place();
    // Without a manager that can, SDL would only believe that the window is as large as the display.
    if (window_manager_helps(window_) && SDL_SetWindowFullscreen(window_, SDL_WINDOW_FULLSCREEN_DESKTOP) == 0) {
      full_screen_ = FullScreen::by_manager;
    } else {
      full_screen_ = FullScreen::by_hand;
      cover_display();
    }
    return;
  }
  if (std::exchange(full_screen_, FullScreen::off) == FullScreen::by_hand) return move_to(before_);
  SDL_SetWindowFullscreen(window_, 0);
  if (was_maximised_) SDL_MaximizeWindow(window_);
}

WindowPlacement Window::placement() {
  const WindowSize now = place().size;
  note_size();
  return {normal() ? now : normal_size_.get(), maximised()};
}

}  // namespace ps::gui
