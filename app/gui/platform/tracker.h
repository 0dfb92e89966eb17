#pragma once
#include <array>
#include <deque>
#include <string>
#include <vector>

#include "gui/input/actions.h"
#include "gui/input/event.h"

struct ImGuiIO;

namespace ps::gui {

/// A key that went down or up in a frame.
struct KeyChange {
  KeyMeanings key;
  bool down = false, repeat = false;
};

/// Whether the key in a place is down, whatever it types.
bool place_is_held(Key place);

/// Mouse, modifiers and keys as the queue of events reports them. Dear ImGui's own back end reads the pointer's global
/// position from the system, 1.86 buttons and modifiers too, and so ignores events that a script pushed into the queue;
/// apply() runs after it and overrules it. Events that would hide one another in one frame (a button pressed and
/// released) are spread over several frames.
class InputTracker {
 public:
  /// Takes mouse, key, text and focus events; ignores others.
  void take(const InputEvent& event);
  /// Moves the events of one frame into ImGui's input. Call after the back end's NewFrame and before ImGui::NewFrame.
  void apply(ImGuiIO& io);
  /// Events are left for the next frame.
  bool pending() const { return !events_.empty(); }
  /// Keys that changed in this frame, in order.
  const std::vector<KeyChange>& keys() const { return keys_; }
  bool lost_focus() const { return lost_focus_; }

 private:
  bool fits_frame(const InputEvent& event) const;
  void apply_event(const InputEvent& event, ImGuiIO& io);

  std::deque<InputEvent> events_;
  float x_ = -1e30f, y_ = -1e30f;
  bool inside_ = false;
  bool buttons_[5] = {};
  bool ctrl_ = false, shift_ = false, alt_ = false;
  std::array<Key, static_cast<std::size_t>(Key::other) + 1>
      down_as_{};  // what the key of a place meant as it went down
  // What has already changed in this frame.
  bool moved_ = false, wheeled_ = false, typed_ = false;
  unsigned buttons_changed_ = 0;
  std::vector<KeyChange> keys_;
  bool lost_focus_ = false;
};

}  // namespace ps::gui
