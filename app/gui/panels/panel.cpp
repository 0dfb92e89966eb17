#include "gui/panels/panel.h"

#include <algorithm>

namespace ps::gui {

Panel& find_panel(const PanelList& panels, std::string_view name) {
  const auto named =
      std::find_if(panels.begin(), panels.end(), [&](const Panel& panel) { return panel.facts.name == name; });
  if (named != panels.end()) return *named;
  return *std::find_if(panels.begin(), panels.end(),
                       [](const Panel& panel) { return panel.facts.place == PanelPlace::below; });
}

}  // namespace ps::gui
