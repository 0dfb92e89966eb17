#pragma once
#include <cstddef>
#include <string>

namespace ps::gui {

/// A line of code, broken into lines of at most `characters` of them, at least 12: at blanks, and behind brackets,
/// commas or dots in what is longer than a line. What goes on is indented further, by less where it would not fit.
std::string code_lines(const std::string& text, std::size_t characters);

}  // namespace ps::gui
