#include <algorithm>
#include <cmath>

#include "gui/widgets/draw.h"
#include "gui/widgets/key_focus.h"
#include "gui/widgets/shorten.h"

namespace ps::gui {

bool section(std::string_view name, std::string_view label, bool& open, std::string_view note) {
  const ImVec2 start = ImGui::GetCursorScreenPos();
  const float end = start.x + ImGui::GetContentRegionAvail().x;
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {px(2), ImGui::GetStyle().FramePadding.y});
  const auto label_left = [&] { return start.x + ImGui::GetFontSize() + 2 * ImGui::GetStyle().FramePadding.x; };
  const bool is_small =
      ImGui::GetFont() == theme().font(Face::small) || text_width(label, Face::bold) > end - label_left();
  const FontScope bold(is_small ? Face::small_bold : Face::bold);
  const float left = label_left();
  const std::string shown = whole_words(label, end - left);
  ImGui::SetNextItemOpen(open);
  constexpr ImGuiTreeNodeFlags flags =
      ImGuiTreeNodeFlags_SpanAvailWidth | ImGuiTreeNodeFlags_FramePadding | ImGuiTreeNodeFlags_NoTreePushOnOpen;
  bool unfolded = open;
  const bool pressed = item(name, {}, [&] {
    unfolded = ImGui::TreeNodeEx("##section", flags, "%s", shown.c_str());
    return unfolded != open;
  });
  ImGui::PopStyleVar();
  if (pressed) open = !open;
  const ImVec2 max = ImGui::GetItemRectMax();
  const float note_left = left + text_width(shown), note_right = end - px(6);
  if (note_left + px(8) + text_width(note, Face::small) <= note_right)  // the label comes first
    draw_text({note_left, start.y}, {note_right, max.y}, note, palette().text_quiet, 1, Face::small);
  controls().record(name, open ? "open" : "closed");
  return open;
}

TreeRow tree_row(std::string_view name, std::string_view text, TreeKind kind, bool selected, bool default_open,
                 float icon_room) {
  const std::string id = full_name(name), label(text);
  ImGuiTreeNodeFlags flags = ImGuiTreeNodeFlags_SpanFullWidth | ImGuiTreeNodeFlags_OpenOnArrow |
                             ImGuiTreeNodeFlags_OpenOnDoubleClick | ImGuiTreeNodeFlags_FramePadding;
  if (kind == TreeKind::leaf)
    flags |= ImGuiTreeNodeFlags_Leaf | ImGuiTreeNodeFlags_NoTreePushOnOpen;
  else if (default_open)
    flags |= ImGuiTreeNodeFlags_DefaultOpen;
  if (selected) flags |= ImGuiTreeNodeFlags_Selected;
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {px(3), px(1)});
  const ImVec2 at{ImGui::GetCursorScreenPos().x + ImGui::GetTreeNodeToLabelSpacing() + icon_room,
                  ImGui::GetCursorScreenPos().y + px(1)};
  const float width = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x - at.x;
  const std::string lines = in_lines(text, width);
  // Dear ImGui makes the row as high as its label: one with as many lines and nothing in them.
  const auto breaks = static_cast<std::size_t>(std::count(lines.begin(), lines.end(), '\n'));
  const std::string blank = std::string(breaks, '\n') + ' ';
  const ImGuiID state = ImGui::GetID(id.c_str());  // now: an open node pushes its name
  const bool open = ImGui::TreeNodeEx(id.c_str(), flags, "%s", blank.c_str());
  ImGui::PopStyleVar();
  draw_lines(at, lines, ImGui::GetStyleColorVec4(ImGuiCol_Text));
  TreeRow row;
  row.open = open && kind == TreeKind::branch;
  row.clicked = ImGui::IsItemClicked() && !ImGui::IsItemToggledOpen();
  if (key_focus().item(id, ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), true)) {
    row.clicked = row.clicked || key_focus().pressed();
    if (kind == TreeKind::branch && key_focus().steps() != 0) {
      ImGui::GetStateStorage()->SetInt(state, key_focus().steps() > 0 ? 1 : 0);
      key_focus().use_steps();
    }
  }
  controls().record(name, label);
  return row;
}

bool begin_numbers(const char* id, int numbers, const NumberColumns& widths) {
  if (!ImGui::BeginTable(id, numbers + 1, ImGuiTableFlags_SizingFixedFit, {widths.all, 0})) return false;
  ImGui::TableSetupColumn(
      "text", widths.text > 0 ? ImGuiTableColumnFlags_WidthFixed : ImGuiTableColumnFlags_WidthStretch, widths.text);
  for (int i = 0; i < numbers; ++i) ImGui::TableSetupColumn("number", ImGuiTableColumnFlags_WidthFixed, widths.numbers);
  return true;
}

void numbers_row(std::string_view text) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  show_paragraph(text);
}

void number_cell(std::string_view digits, std::string_view full) {
  ImGui::TableNextColumn();
  number_text(digits, 0, full);
}

}  // namespace ps::gui
