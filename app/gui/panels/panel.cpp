#include "gui/panels/panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "gui/widgets/widgets.h"

namespace ps::gui {

Panel& find_panel(const PanelList& panels, std::string_view name) {
  const auto named =
      std::find_if(panels.begin(), panels.end(), [&](const Panel& panel) { return panel.facts.name == name; });
  if (named != panels.end()) return *named;
  return *std::find_if(panels.begin(), panels.end(),
                       [](const Panel& panel) { return panel.facts.place == PanelPlace::below; });
}

void begin_tool_content() {
  const ImVec2 room = ImGui::GetContentRegionAvail();
  values().publish("tool/room", fmt::format("{:.0f} {:.0f}", room.x / px(1), room.y / px(1)));
}

}  // namespace ps::gui
