#include "gui/panels/lesson/first_look.h"

#include "gui/widgets/widgets.h"

namespace ps::gui {

float first_look_height() { return 4 * ImGui::GetTextLineHeightWithSpacing() + ImGui::GetFrameHeight() + px(28); }

FirstLookAnswer first_look_offer() {
  const NameScope scope("first-look");
  ImGui::TextWrapped("A first look leads through the window in eight steps. It stays in the menu Lessons.");
  ImGui::Dummy({0, px(2)});
  FirstLookAnswer answer = FirstLookAnswer::none;
  if (button("start", "Show me", Emphasis::primary)) answer = FirstLookAnswer::start;
  ImGui::SameLine();
  if (button("not-now", "Not now", Emphasis::quiet)) answer = FirstLookAnswer::not_now;
  return answer;
}

}  // namespace ps::gui
