#include "gui/widgets/key_focus.h"

#include <imgui_internal.h>  // the window that an item is in

#include <algorithm>
#include <utility>

#include "gui/base/record.h"
#include "gui/theme/theme.h"

namespace ps::gui {
namespace {

constexpr int patience = 10;  // frames that a control may stay away, while a panel opens or scrolls

/// The part of the window that an item lies in: the outermost child window, or the window itself.
std::string region_of_item() {
  const ImGuiWindow* window = ImGui::GetCurrentWindow();
  while (window->ParentWindow && window->ParentWindow != window->RootWindow) window = window->ParentWindow;
  return window->Name;
}

std::optional<char> number_key(const Chord& chord) {
  if (chord.ctrl || chord.alt || chord.shift) return {};
  if (chord.key >= Key::digit_1 && chord.key <= Key::digit_9)
    return static_cast<char>('1' + (static_cast<int>(chord.key) - static_cast<int>(Key::digit_1)));
  if (chord.key == Key::digit_0) return '0';
  if (chord.key == Key::minus) return '-';
  if (chord.key == Key::period) return '.';
  return {};
}

}  // namespace

void KeyFocus::go_to_region(int direction) {
  region_steps_ += direction;
  active_ = true;
}

void KeyFocus::go_to(std::string_view full_name) {
  active_ = true;
  place_ = full_name;
  missing_frames_ = 0;
  seen_ = false;
  controls().reveal(place_);
}

void KeyFocus::leave() {
  if (controls().reveals(place_)) controls().stop_revealing();
  active_ = false;
  place_.clear();
  region_steps_ = moves_ = 0;
}

bool KeyFocus::take_key(const Chord& chord, bool repeat) {
  if (!active_ || chord.ctrl || chord.alt) return false;
  if (chord.key == Key::tab) {
    moves_ += chord.shift ? -1 : 1;
    return true;
  }
  if (chord.shift) return false;
  if (chord.key == Key::escape) {
    if (ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel)) return false;
    leave();
    left_by_escape_ = true;
    return true;
  }
  if (const auto digit = number_key(chord)) {
    digit_ = digit;
    return true;
  }
  if (chord.key == Key::down || chord.key == Key::up) {
    lines_ += chord.key == Key::down ? 1 : -1;
    return true;
  }
  if (chord.key == Key::right || chord.key == Key::left) {
    steps_ += chord.key == Key::right ? 1 : -1;
    return true;
  }
  const bool presses = chord.key == Key::space || chord.key == Key::enter || chord.key == Key::keypad_enter;
  pressed_ = pressed_ || (presses && !repeat);
  return presses;
}

bool KeyFocus::item(std::string_view full_name, ImVec2 min, ImVec2 max, bool can_act) {
  if (!active_) return false;
  const ImGuiWindow* window = ImGui::GetCurrentWindow();
  places_.push_back({std::string(full_name), region_of_item(), min, max, window->ClipRect.Min, window->ClipRect.Max});
  return can_act && full_name == place_;
}

std::size_t KeyFocus::index_of_place() const {
  const auto found = std::find_if(places_.begin(), places_.end(), [&](const Place& p) { return p.name == place_; });
  return static_cast<std::size_t>(found - places_.begin());
}

/// A control of several parts has the keyboard on the first of them; one whose part has gone has it itself.
void KeyFocus::adopt_part() {
  if (place_.empty() || index_of_place() < places_.size()) return;
  const std::string below = place_ + "/", whole = place_.substr(0, place_.rfind('/'));
  const auto part = std::find_if(places_.begin(), places_.end(), [&](const Place& p) {
    return p.name.starts_with(below) || (seen_ && p.name == whole);
  });
  if (part != places_.end()) place_ = part->name;
}

void KeyFocus::move(int by) {
  const int count = static_cast<int>(places_.size());
  const std::size_t place = index_of_place();
  const int from = static_cast<int>(std::min(place < places_.size() ? place : last_index_, places_.size() - 1));
  const std::string& region = places_[static_cast<std::size_t>(from)].region;
  // Within the region, whose controls may be drawn between those of others; round its ends.
  int at = from;
  do {
    at = (at + (by > 0 ? 1 : count - 1)) % count;
  } while (at != from && places_[static_cast<std::size_t>(at)].region != region);
  go_to(places_[static_cast<std::size_t>(at)].name);
}

void KeyFocus::draw_ring() {
  const std::size_t index = index_of_place();
  if (index == places_.size()) return;
  const Place& place = places_[index];
  ImDrawList& list = *ImGui::GetForegroundDrawList();
  list.PushClipRect({place.clip_min.x - px(4), place.clip_min.y - px(4)},
                    {place.clip_max.x + px(4), place.clip_max.y + px(4)});
  const ImVec2 min{place.min.x - px(3), place.min.y - px(3)}, max{place.max.x + px(3), place.max.y + px(3)};
  list.AddRect(min, max, colour_u32(palette().field), px(5), 0, px(4));
  list.AddRect(min, max, colour_u32(palette().text), px(5), 0, px(2));
  list.PopClipRect();
}

void KeyFocus::end_frame() {
  if (ImGui::IsMouseClicked(0)) leave();
  if (active_ && !places_.empty()) {
    adopt_part();
    const std::size_t index = index_of_place();
    if (index < places_.size()) {
      last_index_ = index;
      missing_frames_ = 0;
      seen_ = true;
      // In sight once, it may be scrolled away, and what holds it may be closed.
      const ControlRecord* control = controls().find(place_);
      if (control && controls().visible(*control) && controls().reveals(place_)) controls().stop_revealing();
    } else if (!place_.empty() && ++missing_frames_ > patience) {  // it has gone: the next one in its place
      go_to(places_[std::min(last_index_, places_.size() - 1)].name);
    }
    if (!steps_used_) moves_ += steps_;
    if (!lines_used_) moves_ += lines_;
    if (region_steps_ != 0) {
      std::vector<std::string> regions;
      for (const Place& place : places_)
        if (std::find(regions.begin(), regions.end(), place.region) == regions.end()) regions.push_back(place.region);
      const auto now =
          index < places_.size() ? std::find(regions.begin(), regions.end(), places_[index].region) : regions.end();
      const int count = static_cast<int>(regions.size());
      const int next = now == regions.end() ? (region_steps_ > 0 ? 0 : count - 1)
                                            : static_cast<int>(now - regions.begin()) + region_steps_;
      if (next < 0 || next >= count) {
        leave();
      } else {
        const auto first = std::find_if(places_.begin(), places_.end(), [&](const Place& place) {
          return place.region == regions[static_cast<std::size_t>(next)];
        });
        go_to(first->name);
      }
    } else if (moves_ != 0) {
      for (int i = 0; i < std::abs(moves_); ++i) move(moves_);
    }
    if (active_) draw_ring();
    region_steps_ = moves_ = 0;
  }
  places_.clear();
  steps_ = lines_ = 0;
  pressed_ = steps_used_ = lines_used_ = left_by_escape_ = false;
  digit_.reset();
}

KeyFocus& key_focus() {
  static KeyFocus focus;
  return focus;
}

}  // namespace ps::gui
