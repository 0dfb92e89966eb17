#include "gui/app/ledger_view.h"

#include <fmt/format.h>

#include <algorithm>

#include "gui/widgets/widgets.h"

namespace ps::gui {
namespace {

ImU32 swatch_colour(const Vec3d& value) {
  const auto level = [](double v) { return static_cast<int>(std::clamp(v, 0.0, 1.0) * 255 + 0.5); };
  return IM_COL32(level(value.x), level(value.y), level(value.z), 255);
}

/// The lines at the end that tell what the display does with the sum; they add nothing.
bool tells_only(const PixelStory& story, const LedgerLine& line) {
  return line.event >= 0 && line.event + 1 == static_cast<int>(story.events.size()) && line.level == 0 &&
         line.value == Vec3d(0, 0, 0);
}

}  // namespace

int ledger_view(const std::string& name, const PixelStory& story, int selected_event) {
  int clicked = -1;
  if (!ImGui::BeginTable((name + "/ledger").c_str(), 5, ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_PadOuterX))
    return clicked;
  const float number_width = px(58);
  ImGui::TableSetupColumn("term", ImGuiTableColumnFlags_WidthStretch);
  for (const char* channel : {"red", "green", "blue"})
    ImGui::TableSetupColumn(channel, ImGuiTableColumnFlags_WidthFixed, number_width);
  ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, px(14));

  ImGui::TableNextRow();
  for (const char* heading : {"", "red", "green", "blue", ""}) {
    ImGui::TableNextColumn();
    const FontScope font(Face::small);
    const float width = ImGui::CalcTextSize(heading).x;
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(0.f, ImGui::GetContentRegionAvail().x - width));
    ImGui::TextUnformatted(heading);
  }
  int index = 0;
  for (const auto& line : story.ledger) {
    if (tells_only(story, line)) continue;
    const float indent = px(14) * static_cast<float>(line.level);
    if (indent > 0) ImGui::Indent(indent);
    if (table_row(fmt::format("{}/ledger/{}", name, index), line.term, line.event >= 0 && line.event == selected_event))
      clicked = line.event;
    tooltip(line.term);
    if (indent > 0) ImGui::Unindent(indent);
    for (const double value : {line.value.x, line.value.y, line.value.z}) {
      ImGui::TableNextColumn();
      number_text(value);
    }
    ImGui::TableNextColumn();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float size = px(14);
    ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + size, at.y + size}, swatch_colour(line.value));
    ImGui::GetWindowDrawList()->AddRect(at, {at.x + size, at.y + size}, colour_u32(palette().line));
    ImGui::Dummy({size, size});
    ++index;
  }
  ImGui::EndTable();
  ImGui::PushStyleColor(ImGuiCol_Text, palette().text_quiet);
  ImGui::PushTextWrapPos(0);
  for (const auto& line : story.ledger)
    if (tells_only(story, line)) value_text(fmt::format("{}/display/{}", name, index++), line.term);
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
  return clicked;
}

}  // namespace ps::gui
