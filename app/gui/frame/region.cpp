#include "gui/frame/region.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <map>

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

namespace {
std::map<std::string, Area, std::less<>>& areas() {
  static std::map<std::string, Area, std::less<>> all;
  return all;
}
}  // namespace

void note_area(std::string_view name, const Area& area) { areas().insert_or_assign(std::string(name), area); }

std::string noted_area(std::string_view name) {
  const auto found = areas().find(name);
  if (found == areas().end()) return {};
  const auto& [min, max] = found->second;
  return fmt::format("{},{} {},{}", min.x, min.y, max.x, max.y);
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
  note_area(name, area);
  if (!heading.empty()) region_heading(session, name, heading);
}

}  // namespace ps::gui
