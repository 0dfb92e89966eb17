#include "gui/panels/story/listing_marks.h"

#include <fmt/format.h>

#include <algorithm>

#include "gui/widgets/draw.h"

namespace ps::gui {

void line_ground(int number, ImVec2 size, const LineMarks& marks) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 end{at.x + size.x, at.y + size.y};
  if (marks.answer) {
    const std::string name = fmt::format("line-{}/pick", number);
    if (hit_area(name, size, {})) *marks.answer = number;
    const bool chosen = *marks.answer == number;
    if (ImGui::IsItemHovered() || chosen) list.AddRectFilled(at, end, colour_u32(palette().field_hover), px(2));
    if (chosen) list.AddRect(at, end, colour_u32(palette().text), px(2));
    controls().record(name, chosen ? "on" : "off");
    ImGui::SetCursorScreenPos(at);
  }
  if (marks.marked && number == marks.marked->number)
    list.AddRect(at, end, colour_u32(palette().wrong_mark), px(2), 0, px(2));
}

void right_version(const BugLine& line, float left) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float room = ImGui::GetContentRegionAvail().x;
  const std::string code = line.right.substr(std::min(line.right.find_first_not_of(' '), line.right.size()));
  const std::string lines = in_lines("in B: " + code, room - left - px(4));
  const float height = text_height(lines) + px(2);
  draw_lines({at.x + left, at.y}, lines, palette().text);
  ImGui::GetWindowDrawList()->AddRect(at, {at.x + room, at.y + height}, colour_u32(palette().right_mark), px(2), 0,
                                      px(2));
  controls().record(fmt::format("line-{}/right", line.number), code);
  ImGui::Dummy({room, height});
}

void line_fault(int number, const std::string& text, float left) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float room = ImGui::GetContentRegionAvail().x;
  const std::string lines = in_lines(text, room - left - px(4));
  const float height = text_height(lines) + px(2);
  draw_lines({at.x + left, at.y}, lines, palette().text);
  ImGui::GetWindowDrawList()->AddRect(at, {at.x + room, at.y + height}, colour_u32(palette().wrong_mark), px(2), 0,
                                      px(2));
  controls().record(fmt::format("line-{}/fault", number), text);
  ImGui::Dummy({room, height});
}

}  // namespace ps::gui
