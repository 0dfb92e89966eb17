#pragma once
#include <string>
#include <string_view>

namespace ps::gui {

/// As many of the text's words as fit the width in the present font, with "…" for the others. At least one: that may
/// be too wide.
std::string whole_words(std::string_view text, float width);
/// As many of the text's parts, which ", " and " · " divide, as fit the width, with " …" for the others; where not even
/// the first fits, as many words.
std::string whole_parts(std::string_view text, float width);

}  // namespace ps::gui
