#pragma once
#include "gui/theme/theme.h"
#include "image/painter.h"

namespace ps::gui {

/// The window's shade of a role, for all but Role::own.
ImVec4 shade(const Palette& palette, Role role);

}  // namespace ps::gui
