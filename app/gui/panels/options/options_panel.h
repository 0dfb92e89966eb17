#pragma once
#include <map>
#include <string>

#include "gui/panels/options/object_panel.h"
#include "gui/session/session.h"
#include "options/option.h"

namespace ps::gui {

/// The parts of the pictures that the panel of the picked object needs.
struct PickedParts {
  PickedObject& object;
  bool& gizmo;
};

/// State of the options panel.
struct OptionsPanelState {
  std::string search;
  bool only_differences = false;
  int selected_light = 0;
  bool lights_open = false;
  ObjectPanelState object;
  const Option* pointed = nullptr;                ///< highlighted, until it is changed or searched away from
  bool come_to_pointed = false;                   ///< its row is still to be scrolled into sight
  const Option* sweep = nullptr;                  ///< asked for from a row's menu, until the chart's panel takes it
  std::map<std::string, bool, std::less<>> open;  ///< groups; those that are missing are as at the first start
};

/// The option table with the values of A and of B side by side, in groups, with search. It follows the picked picture:
/// its values are fields, it is what "Copy" copies and what Enter in the palette sets first. Rows that act in neither
/// picture are at the end of their group, folded.
void options_panel(Session& session, OptionsPanelState& state, const PickedParts& picked);

/// Brings an option's row into sight and highlights it.
void point_at_option(OptionsPanelState& state, const Option& option);

}  // namespace ps::gui
