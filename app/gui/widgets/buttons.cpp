#include <algorithm>
#include <cmath>

#include "gui/input/actions.h"
#include "gui/widgets/draw.h"

namespace ps::gui {
namespace {

bool push_button_shape(std::string_view name, std::string_view label, const ControlStyle& style, const ImVec4& fill,
                       const ImVec4& text, const ImVec4* edge) {
  const ImVec2 padding = ImGui::GetStyle().FramePadding;
  const float width = style.width > 0 ? style.width : text_width(label) + 2 * padding.x;
  const bool clicked = hit_area(name, {std::floor(width), ImGui::GetFrameHeight()}, style);
  const ImVec2 min = ImGui::GetItemRectMin(), max = ImGui::GetItemRectMax();
  const ImVec4 colour = state_colour(fill, style);
  if (colour.w > 0)
    ImGui::GetWindowDrawList()->AddRectFilled(min, max, colour_u32(colour), ImGui::GetStyle().FrameRounding);
  if (edge) outline(min, max, *edge);
  const float inset = std::min(padding.x, (max.x - min.x) / 8);
  draw_text({min.x + inset, min.y}, {max.x - inset, max.y}, label, style.disabled.empty() ? text : text_colour(style),
            0.5f);
  controls().record(name, std::string(label), style.disabled.empty());
  style_tooltip(style);
  return clicked;
}

}  // namespace

float button_width(std::string_view label) {
  return std::floor(text_width(label) + 2 * ImGui::GetStyle().FramePadding.x);
}

void same_line_if_room(float width, float spacing) {
  const float right = ImGui::GetWindowPos().x + ImGui::GetContentRegionMax().x;
  const float between = spacing < 0 ? ImGui::GetStyle().ItemSpacing.x : spacing;
  if (ImGui::GetItemRectMax().x + between + width <= right) ImGui::SameLine(0, between);
}

bool button(std::string_view name, std::string_view label, Emphasis emphasis, const ControlStyle& style) {
  const Palette& p = palette();
  switch (emphasis) {
  case Emphasis::plain:
    return push_button_shape(name, label, style, p.field, p.text, &p.line_strong);
  case Emphasis::primary:
    return push_button_shape(name, label, style, p.selection, p.text, &p.text_quiet);
  case Emphasis::quiet:
    return push_button_shape(name, label, style, ImVec4{0, 0, 0, 0}, p.text, nullptr);
  }
  return false;
}

bool button_on_off(std::string_view name, std::string_view label, bool on, const ControlStyle& style) {
  const Palette& p = palette();
  const bool clicked =
      push_button_shape(name, label, style, on ? p.selection : p.field, p.text, on ? &p.text_quiet : &p.line);
  if (on) {  // a bar too: never by colour alone
    const ImVec2 min = ImGui::GetItemRectMin(), max = ImGui::GetItemRectMax();
    ImGui::GetWindowDrawList()->AddRectFilled({min.x + px(8), max.y - px(3)}, {max.x - px(8), max.y - px(1)},
                                              colour_u32(p.text));
  }
  controls().record(name, on ? "on" : "off", style.disabled.empty());
  return clicked;
}

bool toggle(std::string_view name, std::string_view label, bool& value, const ControlStyle& style) {
  const Palette& p = palette();
  const float height = ImGui::GetFrameHeight();
  const float track_width = px(32), track_height = px(18);
  const float gap = label.empty() ? 0 : ImGui::GetStyle().ItemInnerSpacing.x + px(2);
  const bool clicked = hit_area(name, {track_width + gap + text_width(label), height}, style);
  if (clicked) value = !value;
  const ImVec2 min = ImGui::GetItemRectMin(), max = ImGui::GetItemRectMax();
  const bool dead = !style.disabled.empty();
  const bool hovered = ImGui::IsItemHovered() && !dead;
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float y = std::floor((min.y + max.y - track_height) / 2), radius = track_height / 2;
  const ImVec2 track_min{min.x, y}, track_max{min.x + track_width, y + track_height};
  const ImVec4 ink = dead ? p.text_disabled : p.text;
  if (value)
    draw.AddRectFilled(track_min, track_max,
                       colour_u32(dead      ? p.line_strong
                                  : hovered ? p.text_quiet
                                            : p.text),
                       radius);
  else
    draw.AddRectFilled(track_min, track_max, colour_u32(hovered ? p.field_hover : p.field), radius);
  draw.AddRect(track_min, track_max, colour_u32(dead ? p.line_strong : p.text_quiet), radius, 0, px(1.3));
  const float knob_x = value ? track_max.x - radius : track_min.x + radius;
  draw.AddCircleFilled({knob_x, y + radius}, radius - px(4),
                       colour_u32(value  ? p.field
                                  : dead ? p.line_strong
                                         : ink),
                       20);
  draw_text({min.x + track_width + gap, min.y}, {max.x + 1, max.y}, label, ink, 0);
  controls().record(name, value ? "on" : "off", !dead);
  style_tooltip(style);
  return clicked;
}

void menu_action(const Actions& actions, std::string_view action, MenuLabel label) {
  const Action* found = actions.find(action);
  if (!found) return;
  const std::string_view whole = found->label;
  const std::string_view shown = label == MenuLabel::name ? whole.substr(0, whole.find(": ")) : whole;
  const bool checked = found->checked && found->checked();
  if (menu_item(found->name, shown, actions.key_text(found->name), checked,
                actions.enabled(*found) ? "" : "not available now"))
    actions.run(found->name);
  if (shown != whole && actions.enabled(*found)) tooltip(whole);
}

bool menu_item(std::string_view name, std::string_view label, std::string_view keys, bool checked,
               std::string_view disabled) {
  const std::string text(label), chord(keys);
  const DisabledScope dead(!disabled.empty());
  if (!disabled.empty()) ImGui::PushStyleColor(ImGuiCol_Text, palette().text_disabled);
  ImGui::PushID(full_name(name).c_str());
  ImGui::PushStyleColor(ImGuiCol_TextDisabled, palette().text_quiet);
  const bool clicked = ImGui::MenuItem(text.c_str(), chord.empty() ? nullptr : chord.c_str(), checked);
  ImGui::PopStyleColor();
  ImGui::PopID();
  if (!disabled.empty()) ImGui::PopStyleColor();
  controls().record(name, checked ? "on" : text, disabled.empty());
  if (!disabled.empty()) tooltip(disabled);
  return clicked;
}

bool begin_menu(std::string_view name, std::string_view label) {
  const std::string text(label);
  // Recorded first: once the menu is open, the last item and the clip rectangle are those of its list.
  const ImVec2 min = ImGui::GetCursorScreenPos();
  controls().record(name, min, {min.x + text_width(label), min.y + ImGui::GetTextLineHeight()}, text);
  return ImGui::BeginMenu(text.c_str());
}

void end_menu() { ImGui::EndMenu(); }

}  // namespace ps::gui
