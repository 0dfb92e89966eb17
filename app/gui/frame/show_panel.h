#pragma once
#include <string>
#include <string_view>

#include "gui/session/session.h"

namespace ps::gui {

// How the window is divided, as edits of the document's layout.

/// Opens one of the panels below the pictures, by its name.
void show_panel(Session& session, std::string_view name);
/// Opens the region below the pictures, or folds it to one line.
void open_bottom(Session& session, bool open);
/// Whether it is open.
bool bottom_is_open(const Document& document);
/// Gives the window to one region; "" takes it back.
void fill_window(Session& session, const std::string& region);

}  // namespace ps::gui
