#pragma once
#include <string>

#include <vector>

#include "gui/input/actions.h"

namespace ps::gui {

/// Finds an action by typing a part of its label and runs it; then lessons, options with their values, scenes and
/// experiments, also by other words for them.
class CommandPalette {
 public:
  void open();
  bool is_open() const { return open_; }
  void draw(const Actions& actions);

 private:
  bool open_ = false, just_opened_ = false;
  std::string text_;
  int selected_ = 0;
  std::vector<PaletteEntry> entries_;  // besides the actions, as they were when it was opened
};

}  // namespace ps::gui
