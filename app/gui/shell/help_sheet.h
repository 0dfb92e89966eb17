#pragma once
#include "gui/input/actions.h"

namespace ps::gui {

/// All actions with their keys by group, over the whole window. Opened and closed by the action "help".
class HelpSheet {
 public:
  void toggle() { open_ = just_opened_ = !open_; }
  bool open() const { return open_; }
  void draw(const Actions& actions);
  /// Esc closes it; answers whether the key was used.
  bool take_key(const Chord& chord);

 private:
  bool open_ = false, just_opened_ = false;
};

}  // namespace ps::gui
