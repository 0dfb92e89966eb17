#pragma once
#include <span>
#include <string_view>

#include "gui/widgets/widgets.h"

namespace ps::gui {

/// tab_row() with shorter labels, one for each tab, for where the full ones do not fit one row. A shortened tab's
/// tooltip begins with its full label. `reserved`: so much at the row's end is left to something else, window pixels.
bool tab_row(std::string_view name, std::span<const Choice> tabs, std::span<const std::string_view> brief, int& index,
             float reserved = 0);

}  // namespace ps::gui
