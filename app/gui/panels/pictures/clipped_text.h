#pragma once
#include <imgui.h>

#include <string>

#include "gui/theme/theme.h"

namespace ps::gui {

/// Width of one line, in window pixels.
float width_of(Face face, const std::string& text);
/// As many of the text's parts, which ", " and " · " divide, as fit the width, with " …" for the others; where not even
/// the first fits, as many words.
std::string whole_parts(Face face, const std::string& text, float width);
/// Draws text that ends with "..." where it does not fit.
void clipped_text(ImDrawList& list, Face face, ImVec2 at, float width, ImU32 colour, std::string text);

}  // namespace ps::gui
