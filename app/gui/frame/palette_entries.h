#pragma once
#include <vector>

#include "gui/input/actions.h"
#include "gui/panels/panel.h"

namespace ps::gui {

/// Entries of the palette besides the actions: comparisons, lessons and their steps, options and their values,
/// channels, what panels have for it, scenes, experiments, and what other programs have and this one does not.
std::vector<PaletteEntry> palette_entries(const PanelHost& host, const PanelList& panels);

}  // namespace ps::gui
