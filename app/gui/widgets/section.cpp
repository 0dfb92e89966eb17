#include <algorithm>
#include <cmath>

#include "gui/widgets/draw.h"
#include "gui/widgets/key_focus.h"
#include "gui/widgets/shorten.h"

namespace ps::gui {
namespace {

void draw_arrow(ImVec2 middle, bool open, ImU32 ink) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float a = px(3.5), b = px(2.5);
  const ImVec2 tip = open ? ImVec2{middle.x, middle.y + b} : ImVec2{middle.x + b, middle.y};
  const ImVec2 first = open ? ImVec2{middle.x - a, middle.y - b} : ImVec2{middle.x - b, middle.y - a};
  const ImVec2 second = open ? ImVec2{middle.x + a, middle.y - b} : ImVec2{middle.x - b, middle.y + a};
  draw.AddLine(first, tip, ink, px(1.5));
  draw.AddLine(tip, second, ink, px(1.5));
}

}  // namespace

bool section(std::string_view name, std::string_view label, bool& open, std::string_view note) {
  const Palette& p = palette();
  const float width = ImGui::GetContentRegionAvail().x;
  if (hit_area(name, {width, ImGui::GetFrameHeight()}, {})) open = !open;
  const ImVec2 min = ImGui::GetItemRectMin(), max = ImGui::GetItemRectMax();
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  if (ImGui::IsItemHovered()) draw.AddRectFilled(min, max, colour_u32(p.field_hover), ImGui::GetStyle().FrameRounding);
  draw_arrow({min.x + px(8), (min.y + max.y) / 2}, open, colour_u32(p.text_quiet));
  float label_end = 0;
  {
    bool is_small = ImGui::GetFont() == theme().font(Face::small);
    {
      const FontScope bold(Face::bold);
      is_small = is_small || text_width(label) > max.x - min.x - px(20);
    }
    const FontScope bold(is_small ? Face::small_bold : Face::bold);
    const std::string shown = whole_words(label, max.x - min.x - px(20));
    draw_text({min.x + px(20), min.y}, max, shown, p.text, 0);
    label_end = min.x + px(20) + text_width(shown);
  }
  {
    const FontScope small(Face::small);
    const float right = max.x - px(6);
    if (label_end + px(8) + text_width(note) <= right)  // the label comes first
      draw_text({label_end, min.y}, {right, max.y}, note, p.text_quiet, 1);
  }
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

bool table_row(std::string_view name, std::string_view text, bool selected) {
  const std::string id = "##" + full_name(name);
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  const ImVec2 place = ImGui::GetCursorPos();
  bool clicked = ImGui::Selectable(id.c_str(), selected,
                                   ImGuiSelectableFlags_SpanAllColumns | ImGuiSelectableFlags_AllowItemOverlap);
  if (key_focus().item(full_name(name), ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), true))
    clicked = clicked || key_focus().pressed();
  controls().record(name, std::string(text));
  ImGui::SetCursorPos(place);
  ImGui::TextUnformatted(text.data(), text.data() + text.size());
  return clicked;
}

void value_text(std::string_view name, std::string_view text) {
  ImGui::TextUnformatted(text.data(), text.data() + text.size());
  controls().record(name, std::string(text));
}

}  // namespace ps::gui
