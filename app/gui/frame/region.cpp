#include "gui/frame/region.h"

#include <imgui.h>

#include <algorithm>

#include "gui/frame/show_panel.h"
#include "gui/widgets/widgets.h"

namespace ps::gui {
void region_heading(Session& session, std::string_view name, const std::string& heading, float reserved) {
  const bool filled = session.document().layout.filled == name;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const FontScope font(Face::bold);
  ImGui::InvisibleButton("heading",
                         {std::max(ImGui::GetContentRegionAvail().x - reserved, 1.f), ImGui::GetTextLineHeight()});
  const bool hovered = ImGui::IsItemHovered();
  controls().record("region/" + std::string(name), filled ? "fills the window" : heading);
  if (hovered && ImGui::IsMouseDoubleClicked(0)) fill_window(session, filled ? std::string_view() : name);
  ImGui::GetWindowDrawList()->AddText(at, colour_u32(hovered ? palette().text : palette().text_quiet), heading.c_str());
  const FontScope body(Face::body);
  tooltip(filled ? "Double-click or Esc: back to the pictures." : "Double-click: fill the window with this.");
}

void begin_region(Session& session, std::string_view name, const Area& area, const std::string& heading,
                  RegionPadding padding) {
  ImGui::SetCursorScreenPos(area.min);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding,
                      {px(region_padding), padding == RegionPadding::tight ? 0 : px(region_padding)});
  ImGui::BeginChild(std::string(name).c_str(), {area.width(), area.height()}, false,
                    ImGuiWindowFlags_AlwaysUseWindowPadding | ImGuiWindowFlags_NoScrollbar |
                        ImGuiWindowFlags_NoScrollWithMouse);
  ImGui::PopStyleVar();
  if (!heading.empty()) region_heading(session, name, heading);
}

}  // namespace ps::gui
