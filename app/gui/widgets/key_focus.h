#pragma once
#include <imgui.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gui/input/actions.h"

namespace ps::gui {

/// The keyboard's place among the controls. F6 puts it into the first region of the window and on into the next; there
/// Tab and the arrow keys go from control to control, Space and Enter do what a click does, and digits type a number.
/// The key bindings of the window rest meanwhile for these keys alone. Esc, a click, or F6 in the last region end it.
class KeyFocus {
 public:
  /// To the first control of the next region (+1) or of the one before (-1).
  void go_to_region(int direction);
  /// Onto the control of this full name, which may be drawn only later.
  void go_to(std::string_view full_name);
  void leave();
  bool active() const { return active_; }
  bool is_at(std::string_view full_name) const { return active_ && place_ == full_name; }
  /// The full name of the control that has it; empty while none has.
  const std::string& place() const { return place_; }

  /// Takes a key that went down, before the window's bindings get it. Answers whether it was taken.
  bool take_key(const Chord& chord, bool repeat);

  /// For widgets, right after their item was submitted: answers whether it has the keyboard.
  bool item(std::string_view full_name, ImVec2 min, ImVec2 max, bool can_act);
  /// What the control that has the keyboard is asked for in this frame.
  bool pressed() const { return pressed_; }
  int steps() const { return steps_; }                  ///< by Left (-1) and Right (+1)
  std::optional<char> digit() const { return digit_; }  ///< a digit, a sign or a point
  int lines() const { return lines_; }                  ///< by Up (-1) and Down (+1)
  /// The control has used steps() or lines(): they do not move on to another one.
  void use_steps() { steps_used_ = true; }
  void use_lines() { lines_used_ = true; }
  /// Esc has ended it in this frame, and means nothing else.
  bool left_by_escape() const { return left_by_escape_; }

  /// After all controls: moves on, and draws the ring around the control.
  void end_frame();

 private:
  struct Place {
    std::string name, region;
    ImVec2 min, max, clip_min, clip_max;
  };
  std::size_t index_of_place() const;
  void adopt_part();
  void move(int by);
  void draw_ring();

  bool active_ = false;
  std::string place_;
  std::vector<Place> places_;  // of this frame, as they were drawn
  std::size_t last_index_ = 0;
  int region_steps_ = 0, moves_ = 0, steps_ = 0, lines_ = 0;
  int missing_frames_ = 0;  // since the control was drawn last
  bool seen_ = false;       // the control was drawn since the keyboard went to it
  bool pressed_ = false, steps_used_ = false, lines_used_ = false, left_by_escape_ = false;
  std::optional<char> digit_;
};

/// The one of the window.
KeyFocus& key_focus();

}  // namespace ps::gui
