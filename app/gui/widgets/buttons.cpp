#include <algorithm>
#include <cmath>

#include "gui/input/actions.h"
#include "gui/widgets/draw.h"

namespace ps::gui {
namespace {

bool framed_button(std::string_view name, std::string_view label, const ControlStyle& style, const ButtonLook& look) {
  const float width = style.width > 0 ? std::floor(style.width) : button_width(label);
  const bool clicked = word_button(name, label, width, look, style);
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
    return framed_button(name, label, style, {.fill = p.field, .edge = p.line_strong});
  case Emphasis::primary:
    return framed_button(name, label, style, {.fill = p.selection, .edge = p.text_quiet});
  case Emphasis::quiet:
    return framed_button(name, label, style, {});
  }
  return false;
}

bool button_on_off(std::string_view name, std::string_view label, bool on, const ControlStyle& style) {
  const Palette& p = palette();
  const bool clicked = framed_button(
      name, label, style, {.fill = on ? p.selection : p.field, .edge = on ? p.text_quiet : p.line, .on = on});
  controls().record(name, on ? "on" : "off", style.disabled.empty());
  return clicked;
}

bool fill_button(bool filled, std::string_view help) {
  same_line_if_room(button_width("Fill"), px(4));
  return button_on_off("fill", "Fill", filled, {.tooltip = help});
}

void svg_button(const std::function<void()>& save) {
  if (!save) return;
  same_line_if_room(button_width("Save SVG…"), px(2));
  if (button("svg", "Save SVG…", Emphasis::plain, {.tooltip = "Saves this view as a drawing."})) save();
}

bool toggle(std::string_view name, std::string_view label, bool& value, const ControlStyle& style) {
  ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, line_thickness());
  ImGui::PushStyleColor(ImGuiCol_Border, palette().text_quiet);
  ImGui::PushStyleColor(ImGuiCol_Text, text_colour(style));
  ImGui::PushStyleColor(ImGuiCol_CheckMark, text_colour(style));
  const std::string words(label);
  bool ticked = value;
  const bool clicked = item(name, style, [&] { return ImGui::Checkbox(words.c_str(), &ticked); });
  if (clicked) value = !value;
  ImGui::PopStyleColor(3);
  ImGui::PopStyleVar();
  controls().record(name, value ? "on" : "off", style.disabled.empty());
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
