#pragma once
#include <vector>

#include "gui/input/actions.h"
#include "gui/panels/kept/kept_panel.h"
#include "gui/panels/lesson/lesson_panel.h"
#include "gui/panels/options/options_panel.h"

namespace ps::gui {

/// Entries of the palette besides the actions: lessons, options and their values, presets and bookmarks,
/// scenes and experiments.
/// `show_options` brings the list of options into sight.
std::vector<PaletteEntry> palette_entries(Session& session, LessonColumn& column, OptionsPanelState& options,
                                          const KeptState& kept, const std::function<void()>& show_options);

}  // namespace ps::gui
