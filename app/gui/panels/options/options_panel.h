#pragma once
#include <map>
#include <string>

#include "gui/session/session.h"
#include "options/option.h"

namespace ps::gui {

/// What the options panel remembers of itself.
struct OptionsPanelState {
  Side side = Side::a;
  std::string search;
  bool only_differences = false;
  int selected_light = 0;
  bool lights_open = false;
  const Option* pointed = nullptr;                ///< highlighted, until it is changed or searched away from
  bool come_to_pointed = false;                   ///< its row is still to be scrolled into sight
  const Option* sweep = nullptr;                  ///< asked for from a row's menu, until whoever draws charts takes it
  std::map<std::string, bool, std::less<>> open;  ///< groups; those that are missing are as at the first start
};

/// All rows of the option table for one side at a time, in their groups, with search and comparison with the other
/// side.
void options_panel(Session& session, OptionsPanelState& state);

/// Brings an option's row into sight and highlights it.
void point_at_option(OptionsPanelState& state, const Option& option);

}  // namespace ps::gui
