#pragma once
#include <vector>

#include "gui/input/actions.h"
#include "gui/session/session.h"

namespace ps::gui {

/// Entries of the palette for the values of options: "Shading: Gouraud", which sets it in A, and again for B. Choices
/// and switches have one entry for each value and picture; numbers have none.
std::vector<PaletteEntry> value_entries(Session& session);

}  // namespace ps::gui
