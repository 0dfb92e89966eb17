#include "gui/panels/lesson/first_look.h"

#include "gui/widgets/draw.h"
#include "gui/widgets/widgets.h"

namespace ps::gui {
namespace {

constexpr std::string_view offer =
    "A first look leads through the window in eight steps. It stays in the menu Lessons.";

}  // namespace

float first_look_height(float width) {
  const float heading = ImGui::GetTextLineHeightWithSpacing(), spacing = ImGui::GetStyle().ItemSpacing.y;
  return heading + text_height(in_lines(offer, width)) + ImGui::GetFrameHeight() + 3 * spacing + px(26);
}

FirstLookAnswer first_look_offer() {
  const NameScope scope("first-look");
  show_paragraph(offer);
  ImGui::Dummy({0, px(2)});
  FirstLookAnswer answer = FirstLookAnswer::none;
  if (button("start", "Start", Emphasis::primary)) answer = FirstLookAnswer::start;
  ImGui::SameLine();
  if (button("not-now", "Later", Emphasis::quiet)) answer = FirstLookAnswer::not_now;
  return answer;
}

}  // namespace ps::gui
