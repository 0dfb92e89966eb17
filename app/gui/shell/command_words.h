#pragma once
#include <string_view>

namespace ps::gui {

/// What else people call a command, with commas between: "dark mode, night mode". Empty where its label says it all.
std::string_view command_words(std::string_view action);

}  // namespace ps::gui
