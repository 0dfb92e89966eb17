#pragma once
#include <string>
#include <string_view>

#include "gui/input/actions.h"

namespace ps::gui {

/// The actions that with_key() asks; nullptr before there are any. Main thread only.
void set_key_hints(const Actions* actions);
/// A sentence with the action's key, as the keyboard has it, for tooltips: "Back to the options (Y)." The sentence
/// alone where it has none.
std::string with_key(std::string_view sentence, std::string_view action);

}  // namespace ps::gui
