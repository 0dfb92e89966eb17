#pragma once
#include <string>
#include <string_view>

#include "gui/widgets/widgets.h"

namespace ps::gui {

struct TextEdit {
  bool changed = false;
  bool entered = false;  ///< Enter ended the typing
};
/// A field for a short text, with a clear button; `hint` is shown while it is empty.
TextEdit text_field(std::string_view name, std::string& text, std::string_view hint, const ControlStyle& style = {});

}  // namespace ps::gui
