#pragma once
#include <vector>

#include "gui/input/actions.h"
#include "gui/session/session.h"

namespace ps::gui {

/// Entries of the palette for the values of options, "Shading: Gouraud", each to be set in A or in B, the picked
/// picture first. Numbers have none.
std::vector<PaletteEntry> value_entries(Session& session);

/// Likewise for the channels: "Show: Normal".
std::vector<PaletteEntry> channel_entries(Session& session);

}  // namespace ps::gui
