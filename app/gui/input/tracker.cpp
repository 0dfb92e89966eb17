#include "gui/input/tracker.h"

#include <SDL.h>
#include <imgui.h>

#include <algorithm>
#include <cfloat>

namespace ps::gui {

void InputTracker::take(const SDL_Event& event) {
  Event out;
  switch (event.type) {
  case SDL_MOUSEMOTION:
    if (event.motion.which == SDL_TOUCH_MOUSEID) return;
    out.kind = Kind::move;
    out.x = static_cast<float>(event.motion.x);
    out.y = static_cast<float>(event.motion.y);
    break;
  case SDL_MOUSEBUTTONDOWN:
  case SDL_MOUSEBUTTONUP: {
    static constexpr int imgui_button[] = {-1, 0, 2, 1, 3, 4};  // SDL counts left, middle, right
    if (event.button.button < 1 || event.button.button > 5) return;
    // The press has its own position, which may be beyond the last movement.
    Event move;
    move.x = static_cast<float>(event.button.x);
    move.y = static_cast<float>(event.button.y);
    events_.push_back(move);
    out.kind = Kind::button;
    out.code = imgui_button[event.button.button];
    out.down = event.type == SDL_MOUSEBUTTONDOWN;
    break;
  }
  case SDL_MOUSEWHEEL:
    out.kind = Kind::wheel;
    out.x = event.wheel.preciseX;
    out.y = event.wheel.preciseY;
    break;
  case SDL_KEYDOWN:
  case SDL_KEYUP:
    out.kind = Kind::key;
    out.code = event.key.keysym.scancode;
    out.down = event.type == SDL_KEYDOWN;
    out.repeat = event.key.repeat != 0;
    out.ctrl = (event.key.keysym.mod & KMOD_CTRL) != 0;
    out.shift = (event.key.keysym.mod & KMOD_SHIFT) != 0;
    out.alt = (event.key.keysym.mod & KMOD_ALT) != 0;
    break;
  case SDL_TEXTINPUT:
    out.kind = Kind::text;
    out.text = event.text.text;
    break;
  case SDL_WINDOWEVENT:
    if (event.window.event == SDL_WINDOWEVENT_LEAVE)
      out.kind = Kind::leave;
    else if (event.window.event == SDL_WINDOWEVENT_FOCUS_LOST)
      out.kind = Kind::focus_lost;
    else
      return;
    break;
  default:
    return;
  }
  // Of several movements in a row only the last matters, so that a slow frame does not make the pointer lag.
  if (out.kind == Kind::move && !events_.empty() && events_.back().kind == Kind::move)
    events_.back() = out;
  else
    events_.push_back(out);
}

bool InputTracker::fits_frame(const Event& event) const {
  switch (event.kind) {
  case Kind::move:
    if (inside_ && event.x == x_ && event.y == y_) return true;
    return buttons_changed_ == 0 && !wheeled_ && keys_.empty() && !typed_;
  case Kind::leave:
    return buttons_changed_ == 0 && !wheeled_;
  case Kind::button:
    return (buttons_changed_ & (1u << event.code)) == 0 && !moved_ && !wheeled_ && keys_.empty();
  case Kind::wheel:
    return !moved_ && buttons_changed_ == 0 && !wheeled_ && keys_.empty();
  case Kind::key:
    if (buttons_changed_ != 0 || moved_ || typed_) return false;
    return std::none_of(keys_.begin(), keys_.end(), [&](const KeyChange& k) { return k.chord.scancode == event.code; });
  case Kind::text:
    return buttons_changed_ == 0 && !moved_;
  case Kind::focus_lost:
    return keys_.empty() && buttons_changed_ == 0;
  }
  return true;
}

void InputTracker::apply_event(const Event& event, ImGuiIO& io) {
  switch (event.kind) {
  case Kind::move:
    moved_ = moved_ || event.x != x_ || event.y != y_ || !inside_;
    x_ = event.x;
    y_ = event.y;
    inside_ = true;
    break;
  case Kind::leave:
    inside_ = false;
    break;
  case Kind::button:
    buttons_[event.code] = event.down;
    buttons_changed_ |= 1u << event.code;
    break;
  case Kind::wheel:
    io.MouseWheelH += event.x;
    io.MouseWheel += event.y;
    wheeled_ = true;
    break;
  case Kind::key:
    ctrl_ = event.ctrl;
    shift_ = event.shift;
    alt_ = event.alt;
    if (event.code >= 0 && event.code < IM_ARRAYSIZE(io.KeysDown)) io.KeysDown[event.code] = event.down;
    keys_.push_back({{event.code, event.ctrl, event.shift, event.alt}, event.down, event.repeat});
    break;
  case Kind::text:
    io.AddInputCharactersUTF8(event.text.c_str());
    typed_ = true;
    break;
  case Kind::focus_lost:
    std::fill(std::begin(io.KeysDown), std::end(io.KeysDown), false);
    std::fill(std::begin(buttons_), std::end(buttons_), false);
    ctrl_ = shift_ = alt_ = false;
    lost_focus_ = true;
    break;
  }
}

void InputTracker::apply(ImGuiIO& io) {
  moved_ = wheeled_ = typed_ = lost_focus_ = false;
  buttons_changed_ = 0;
  keys_.clear();
  while (!events_.empty() && fits_frame(events_.front())) {
    apply_event(events_.front(), io);
    events_.pop_front();
  }
  const bool dragging = std::any_of(std::begin(buttons_), std::end(buttons_), [](bool down) { return down; });
  io.MousePos = inside_ || dragging ? ImVec2(x_, y_) : ImVec2(-FLT_MAX, -FLT_MAX);
  std::copy(std::begin(buttons_), std::end(buttons_), io.MouseDown);
  io.KeyCtrl = ctrl_;
  io.KeyShift = shift_;
  io.KeyAlt = alt_;
  io.KeySuper = false;
}

}  // namespace ps::gui
