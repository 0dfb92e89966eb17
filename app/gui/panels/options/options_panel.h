#pragma once
#include <map>
#include <string>

#include "gui/panels/options/object_panel.h"
#include "gui/panels/panel.h"
#include "options/option.h"

namespace ps::gui {

/// State of the options panel.
struct OptionsPanelState {
  std::string search;
  bool only_differences = false;
  int selected_light = 0;
  bool lights_open = false;
  ObjectPanelState object;
  const Option* pointed = nullptr;                ///< highlighted, until it is changed or searched away from
  bool come_to_pointed = false;                   ///< its row is still to be scrolled into sight
  std::map<std::string, bool, std::less<>> open;  ///< groups; those that are missing are as at the first start
};

/// The option table with the values of A and of B side by side, in groups, with search. It follows the picked picture:
/// its values are fields, it is what "Copy" copies and what Enter in the palette sets first. Rows that act in neither
/// picture are at the end of their group, folded.
class OptionsPanel final : public Panel {
 public:
  OptionsPanel(const PanelHost& host, ObjectSelection& selection);
  bool draw(const Context& context) override;
  void add_actions(Actions& actions) override;
  void take(const PanelMessage& message) override;

 private:
  ObjectSelection& selection_;
  OptionsPanelState state_;
};

}  // namespace ps::gui
