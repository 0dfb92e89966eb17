#pragma once
#include <functional>
#include <string>
#include <vector>

#include "gui/input/actions.h"
#include "gui/panels/kept/kept_list.h"
#include "gui/session/session.h"

namespace ps::gui {

/// Named sets of options and named screens, kept from one start to the next.
struct KeptState {
  std::vector<KeptEntry> presets;    ///< options that are not at their defaults, "key=value" with blanks between them
  std::vector<KeptEntry> bookmarks;  ///< permalinks
  bool open = false, just_opened = false;
  std::string preset_name, bookmark_name;  ///< being typed
  std::function<void(const char* key, std::string lines)> remember;
};
inline constexpr const char *presets_key = "app/presets", *bookmarks_key = "app/bookmarks";

/// Sets all options of a side as the preset has them. An entry that does not fit this version becomes a message.
void apply_preset(Session& session, Side side, const KeptEntry& preset);
void keep_preset(Session& session, KeptState& state, Side side, const std::string& name);
void keep_bookmark(Session& session, KeptState& state, const std::string& name);

/// The list over the window: what is kept, with buttons to use and to delete it, and fields for new names.
void kept_panel(Session& session, KeptState& state);

/// What is kept, for the palette.
std::vector<PaletteEntry> kept_entries(Session& session, const KeptState& state);

}  // namespace ps::gui
