#include "gui/widgets/draw.h"

#include <imgui_internal.h>

#include <algorithm>

#include "gui/base/fit.h"
#include "gui/widgets/key_focus.h"

namespace ps::gui {

void draw_swatch(ImDrawList& list, ImVec2 corner, ImVec2 size, ImU32 colour) {
  const ImVec2 end{corner.x + size.x, corner.y + size.y};
  list.AddRectFilled(corner, end, colour, px(3));
  list.AddRect(corner, end, colour_u32(palette().line_strong), px(3));
}

void swatch(const std::array<int, 3>& levels, ImVec2 size) {
  if (size.x <= 0) size = {ImGui::GetTextLineHeight(), ImGui::GetTextLineHeight()};
  draw_swatch(*ImGui::GetWindowDrawList(), ImGui::GetCursorScreenPos(), size,
              IM_COL32(levels[0], levels[1], levels[2], 255));
  ImGui::Dummy(size);
}

void draw_tick(ImVec2 row, float height) {
  const float size = px(13);
  ImGui::RenderCheckMark(ImGui::GetWindowDrawList(), {row.x + px(3), row.y + (height - size) / 2},
                         colour_u32(palette().right_mark), size);
}

void side_bar(ImDrawList& list, ImVec2 min, ImVec2 max, Side side) {
  list.AddRectFilled(min, max, colour_u32(side == Side::a ? palette().a : palette().b));
}

void side_letter(Side side) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float line = ImGui::GetTextLineHeight(), bar = px(4), gap = px(4);
  const std::string_view letter = side == Side::a ? "A" : "B";
  // In a line with controls, text keeps their base line.
  const float y = at.y + ImGui::GetCurrentWindow()->DC.CurrLineTextBaseOffset;
  side_bar(*ImGui::GetWindowDrawList(), {at.x, y + px(1)}, {at.x + bar, y + line - px(1)}, side);
  ImGui::SetCursorScreenPos({at.x + bar + gap, at.y});
  ImGui::TextUnformatted(letter.data(), letter.data() + letter.size());
}

void attention_bar(ImDrawList& list, ImVec2 min, ImVec2 max) {
  list.AddRectFilled(min, max, colour_u32(palette().attention));
  list.AddRect(min, max, colour_u32(palette().text_quiet));
}

bool item(std::string_view name, const ControlStyle& style, const std::function<bool()>& make) {
  const DisabledScope disabled(!style.disabled.empty());
  ImGui::PushID(full_name(name).c_str());
  const bool clicked = make();
  ImGui::PopID();
  if (name.starts_with("##")) return clicked;  // a part of a control that asks for the keyboard itself
  const bool has_keys =
      key_focus().item(full_name(name), ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), style.disabled.empty());
  return clicked || (has_keys && key_focus().pressed());
}

bool word_button(std::string_view name, std::string_view label, float width, const ButtonLook& look,
                 const ControlStyle& style) {
  const float inset = std::min(ImGui::GetStyle().FramePadding.x, width / 8);
  const float above =
      look.height > 0 ? std::max(0.0f, look.height - text_height(label)) / 2 : ImGui::GetStyle().FramePadding.y;
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {inset, above});
  ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, look.edge.w > 0 ? line_thickness() : 0);
  ImGui::PushStyleColor(ImGuiCol_Button, style.disabled.empty() || look.fill.w == 0 ? look.fill : palette().panel);
  ImGui::PushStyleColor(ImGuiCol_Border, look.edge);
  ImGui::PushStyleColor(ImGuiCol_Text, style.disabled.empty() ? look.text : palette().text_disabled);
  const std::string words(label);
  ImGui::PushStyleVar(ImGuiStyleVar_ButtonTextAlign, {look.align, 0.5f});
  const bool clicked = item(name, style, [&] { return ImGui::Button(words.c_str(), {width, look.height}); });
  ImGui::PopStyleColor(3);
  ImGui::PopStyleVar(3);
  const ImVec2 min = ImGui::GetItemRectMin(), max = ImGui::GetItemRectMax();
  if (look.on)
    ImGui::GetWindowDrawList()->AddRectFilled({min.x + inset, max.y - px(3)}, {max.x - inset, max.y - px(1)},
                                              colour_u32(text_colour(style)));
  if (text_width(label) > max.x - min.x - 2 * inset + 1) fit_watch().shortened(min, max, label);
  return clicked;
}

bool hit_area(std::string_view name, ImVec2 size, const ControlStyle& style) {
  return item(name, style, [&] {
    return ImGui::InvisibleButton("##hit", {std::max(1.0f, size.x), std::max(1.0f, size.y)});
  });
}

bool list_row(std::string_view name, ImVec2 size, bool selected) {
  const bool clicked = hit_area(name, {size.x > 0 ? size.x : ImGui::GetContentRegionAvail().x, size.y}, {});
  const ImVec2 min = ImGui::GetItemRectMin(), max = ImGui::GetItemRectMax();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (selected || ImGui::IsItemHovered())
    list.AddRectFilled(min, max, colour_u32(selected ? palette().selection : palette().field_hover), px(3));
  if (selected) list.AddRectFilled(min, {min.x + px(3), max.y}, colour_u32(palette().text));
  return clicked;
}

void style_tooltip(const ControlStyle& style) {
  if (style.tooltip.empty() && style.disabled.empty()) return;
  if (!begin_tooltip()) return;
  if (!style.tooltip.empty()) ImGui::TextUnformatted(style.tooltip.data(), style.tooltip.data() + style.tooltip.size());
  if (!style.disabled.empty())
    ImGui::TextColored(palette().text_quiet, "Not now: %.*s", static_cast<int>(style.disabled.size()),
                       style.disabled.data());
  end_tooltip();
}

ImVec4 state_colour(const ImVec4& idle, const ControlStyle& style) {
  if (!style.disabled.empty()) return palette().panel;
  if (ImGui::IsItemActive()) return palette().field_active;
  if (ImGui::IsItemHovered()) return palette().field_hover;
  return idle;
}

void outline(ImVec2 min, ImVec2 max, const ImVec4& colour) {
  ImGui::GetWindowDrawList()->AddRect({min.x + 0.5f, min.y + 0.5f}, {max.x - 0.5f, max.y - 0.5f}, colour_u32(colour),
                                      ImGui::GetStyle().FrameRounding, 0, line_thickness());
}

float full_width(const ControlStyle& style) {
  return std::floor(style.width > 0 ? style.width : std::max(px(40), ImGui::GetContentRegionAvail().x));
}

}  // namespace ps::gui
