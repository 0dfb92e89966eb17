#pragma once
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "gui/base/values.h"
#include "gui/panels/panel.h"
#include "gui/session/session.h"

namespace ps::gui {

/// State of the tools below the pictures beside the document: of each group the tool that was open last.
struct DrawerState {
  std::array<std::string_view, 4> last{};
};

/// The tabs of the drawer: four groups, and beside them the tools of the open one. They act on the document.
void drawer_tabs(Session& session, const PanelList& panels, DrawerState& state);

/// A key for each group, which opens it, and pressed again its next tool.
void add_drawer_actions(Actions& actions, Session& session, const PanelList& panels, DrawerState& state);

/// bottom/TOOL: whether the tool is in sight, also while the tabs of other groups are.
void offer_drawer_values(Values& out, Session& session, const PanelList& panels);

}  // namespace ps::gui
