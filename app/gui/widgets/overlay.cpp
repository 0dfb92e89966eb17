#include "gui/widgets/overlay.h"

#include <algorithm>

#include "gui/widgets/widgets.h"

namespace ps::gui {

namespace {

constexpr double padding = 24, close_width = 84;

}  // namespace

Overlay::Overlay(const char* id, ImVec2 largest, bool& just_opened) : just_opened_(just_opened) {
  const ImVec2 display = ImGui::GetIO().DisplaySize, most{display.x - px(40), display.y - px(40)};
  ImGui::SetNextWindowPos({display.x / 2, display.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSize({std::min(px(largest.x), most.x), std::min(px(largest.y), most.y)});
  ImGui::SetNextWindowSizeConstraints({0, 0}, {display.x, most.y});
  if (just_opened || largest.y > 0) ImGui::SetNextWindowFocus();  // a list has to be before it
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {px(padding), px(16)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1.0f);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, px(6));
  ImGui::PushStyleColor(ImGuiCol_WindowBg, palette().field);
  ImGui::Begin(id, nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
}

bool Overlay::left() const {
  return ImGui::IsMouseClicked(0) && !just_opened_ && !ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup) &&
         !ImGui::IsWindowHovered(ImGuiHoveredFlags_RootAndChildWindows |
                                 ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
}

Overlay::~Overlay() {
  just_opened_ = false;
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(3);
}

bool overlay_title(const char* title) {
  {
    const FontScope font(Face::heading);
    ImGui::TextUnformatted(title);
  }
  const bool closed = close_at_end();
  ImGui::Dummy({0, px(4)});
  return closed;
}

bool close_at_end() {
  ImGui::SameLine(ImGui::GetWindowWidth() - px(padding) - px(close_width));
  return button("close", "Close", Emphasis::plain, {.width = px(close_width)});
}

}  // namespace ps::gui
