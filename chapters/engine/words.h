#pragma once
#include <string>
#include <string_view>

/// Cutting texts into lines and words.

namespace ps {

/// The text without blanks, tabs and carriage returns at its ends.
std::string_view without_blanks(std::string_view text);

std::string in_lower_case(std::string_view text);

/// The first word of a text, which is cut off with the spaces behind it.
std::string_view take_word(std::string_view& text);

/// The first line of a text, which is cut off with its '\n'; the line is without it.
std::string_view take_line(std::string_view& text);

}  // namespace ps
