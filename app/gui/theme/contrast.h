#pragma once
#include <string>
#include <vector>

#include "gui/theme/theme.h"

namespace ps::gui {

/// What a colour is used for decides how much it must stand out: text at 7:1 (WCAG 2, level AAA), bars, rings and small
/// signs at 3:1 (level AA of what is not text).
inline constexpr double text_contrast = 7, mark_contrast = 3;

/// Every pair of colours in use, of the palette and of Dear ImGui's table made from it, that stands out too little:
/// "text_disabled on field: 4.61, needs 7". Empty for a palette that can be used.
std::vector<std::string> contrast_faults(const Palette& palette);

}  // namespace ps::gui
