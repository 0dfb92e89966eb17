#pragma once
#include <vector>

#include "gui/input/actions.h"
#include "gui/panels/panel.h"

namespace ps::gui {

/// Entries of the palette besides the actions: lessons, options and their values, what panels have for it,
/// scenes and experiments.
std::vector<PaletteEntry> palette_entries(const PanelHost& host, const PanelList& panels);

}  // namespace ps::gui
