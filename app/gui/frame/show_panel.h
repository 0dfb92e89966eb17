#pragma once
#include <string>
#include <string_view>

#include "engine/screen_names.h"
#include "gui/base/region_names.h"
#include "gui/panels/lesson/lesson_panel.h"
#include "gui/panels/panel.h"
#include "gui/session/session.h"

namespace ps::gui {

// How the window is divided, as edits of the document's layout.

/// Changes the mode of the window. The region that filled it gives it back.
void set_mode(Session& session, ScreenMode mode);

/// From the presenter back to the lesson, or without one to exploring. Answers whether the presenter was left.
bool leave_presenter(Session& session);

/// Opens one of the panels below the pictures, by its name: in the drawer, or in a lesson on its stage.
void show_panel(Session& session, std::string_view name);
/// Into the mode that has room for a tool: a study for what looks at whole pictures, exploring for what looks at one
/// pixel. A lesson has room for both, and so has either mode for the list of the worst pixels.
void make_room_for(Session& session, const Panel& tool);
/// Opens the region below the pictures, or folds it to one line.
void open_bottom(Session& session, bool open);
/// Whether it is open.
bool bottom_is_open(const Document& document);
/// Gives the window to one region; "" takes it back.
void fill_window(Session& session, std::string_view region);

}  // namespace ps::gui
