#include "gui/widgets/overlay.h"

#include <algorithm>

#include "gui/theme/theme.h"

namespace ps::gui {

Overlay::Overlay(const char* id, ImVec2 corner, ImVec2 size, ImGuiWindowFlags flags, bool& just_opened)
    : just_opened_(just_opened) {
  ImGui::SetNextWindowPos(corner);
  ImGui::SetNextWindowSize(size);
  ImGui::SetNextWindowFocus();
  begin(id, flags);
}

Overlay::Overlay(const char* id, float width, bool& just_opened) : just_opened_(just_opened) {
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({display.x / 2, display.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSize({std::min(width, display.x - px(40)), 0});
  if (just_opened) ImGui::SetNextWindowFocus();  // once, else no list could open
  begin(id, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
}

void Overlay::begin(const char* id, ImGuiWindowFlags flags) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {px(24), px(16)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1.0f);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, px(6));
  ImGui::PushStyleColor(ImGuiCol_WindowBg, palette().field);
  ImGui::Begin(id, nullptr, flags);
}

bool Overlay::left() const {
  return ImGui::IsMouseClicked(0) && !just_opened_ &&
         !ImGui::IsWindowHovered(ImGuiHoveredFlags_RootAndChildWindows |
                                 ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
}

Overlay::~Overlay() {
  just_opened_ = false;
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(3);
}

}  // namespace ps::gui
