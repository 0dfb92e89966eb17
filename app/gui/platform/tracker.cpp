#include "gui/platform/tracker.h"

#include <imgui.h>

#include <algorithm>
#include <bitset>
#include <cfloat>

#include "gui/platform/imgui_version.h"

namespace ps::gui {

namespace {

using Kind = InputEvent::Kind;

int number_of(MouseButton button) { return static_cast<int>(button); }  // as Dear ImGui counts them
std::size_t index_of(Key key) { return static_cast<std::size_t>(key); }

std::bitset<static_cast<std::size_t>(Key::other) + 1>& held_places() {
  static std::bitset<static_cast<std::size_t>(Key::other) + 1> held;
  return held;
}

}  // namespace

bool place_is_held(Key place) { return held_places().test(index_of(place)); }

void InputTracker::take(const InputEvent& event) {
  if (event.kind == Kind::drop || event.kind == Kind::close || event.kind == Kind::other) return;
  // The press has its own position, which may be beyond the last movement.
  if (event.kind == Kind::button) events_.push_back({.kind = Kind::move, .at = event.at});
  // Of several movements in a row only the last matters, so that a slow frame does not make the pointer lag.
  if (event.kind == Kind::move && !events_.empty() && events_.back().kind == Kind::move)
    events_.back() = event;
  else
    events_.push_back(event);
}

bool InputTracker::fits_frame(const InputEvent& event) const {
  switch (event.kind) {
  case Kind::move:
    if (inside_ && event.at.x == x_ && event.at.y == y_) return true;
    return buttons_changed_ == 0 && !wheeled_ && keys_.empty() && !typed_;
  case Kind::leave:
    return buttons_changed_ == 0 && !wheeled_;
  case Kind::button:
    return (buttons_changed_ & (1u << number_of(event.button))) == 0 && !moved_ && !wheeled_ && keys_.empty();
  case Kind::wheel:
    return !moved_ && buttons_changed_ == 0 && !wheeled_ && keys_.empty();
  case Kind::key:
    if (buttons_changed_ != 0 || moved_ || typed_) return false;
    return std::none_of(keys_.begin(), keys_.end(),
                        [&](const KeyChange& k) { return k.key.at_place.key == event.key; });
  case Kind::text:
    return buttons_changed_ == 0 && !moved_;
  case Kind::focus_lost:
    return keys_.empty() && buttons_changed_ == 0;
  case Kind::drop:
  case Kind::close:
  case Kind::other:
    break;
  }
  return true;
}

void InputTracker::apply_event(const InputEvent& event, ImGuiIO& io) {
  switch (event.kind) {
  case Kind::move:
    moved_ = moved_ || event.at.x != x_ || event.at.y != y_ || !inside_;
    x_ = event.at.x;
    y_ = event.at.y;
    inside_ = true;
    break;
  case Kind::leave:
    inside_ = false;
    break;
  case Kind::button:
    buttons_[number_of(event.button)] = event.down;
    buttons_changed_ |= 1u << number_of(event.button);
    break;
  case Kind::wheel:
    io.MouseWheelH += event.at.x;
    io.MouseWheel += event.at.y;
    wheeled_ = true;
    break;
  case Kind::key: {
    ctrl_ = event.ctrl;
    shift_ = event.shift;
    alt_ = event.alt || event.right_alt;
    held_places().set(index_of(event.key), event.down);
    const KeyMeanings key =
        keyboard_layout().meanings({event.key, event.ctrl, event.shift, event.alt, event.right_alt});
    // The same comes up, whatever became of the modifiers and the layout.
    Key& meant = down_as_[index_of(event.key)];
    if (event.down && !event.repeat) meant = key.first().key;
    set_key(io, meant, event.down);
    keys_.push_back({key, event.down, event.repeat});
    break;
  }
  case Kind::text:
    io.AddInputCharactersUTF8(event.text.c_str());
    typed_ = true;
    break;
  case Kind::focus_lost:
    io.ClearInputKeys();
    held_places().reset();
    std::fill(std::begin(buttons_), std::end(buttons_), false);
    ctrl_ = shift_ = alt_ = false;
    lost_focus_ = true;
    break;
  case Kind::drop:
  case Kind::close:
  case Kind::other:
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
  set_pointer(io, inside_ || dragging ? ImVec2(x_, y_) : ImVec2(-FLT_MAX, -FLT_MAX));
  std::copy(std::begin(buttons_), std::end(buttons_), io.MouseDown);
  set_modifiers(io, ctrl_, shift_, alt_);
}

}  // namespace ps::gui
