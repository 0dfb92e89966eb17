#include <imgui.h>
#include <imgui_stdlib.h>

#include "gui/platform/imgui_version.h"
#include "gui/widgets/draw.h"
#include "gui/widgets/key_focus.h"
#include "gui/widgets/text_field.h"

namespace ps::gui {
namespace {

std::string begun_by_key;  ///< the field that Enter was pressed on: typing begins in the next frame

enum class FieldIcon { none, lens };

TextEdit typed_field(std::string_view name, std::string& text, std::string_view hint, const ControlStyle& style,
                     FieldIcon icon) {
  const Palette& p = palette();
  const float width = full_width(style), clear = ImGui::GetFrameHeight();
  const std::string id = "##" + full_name(name), shown_hint(hint);
  const ImVec2 start = ImGui::GetCursorScreenPos();
  if (begun_by_key == full_name(name)) {
    give_keyboard_to_next_item();
    begun_by_key.clear();
  }
  ImGui::SetNextItemWidth(width);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding,
                      {px(icon == FieldIcon::lens ? 28 : 8), ImGui::GetStyle().FramePadding.y});
  ImGui::PushStyleColor(ImGuiCol_TextDisabled, p.text_quiet);
  TextEdit edit;
  {
    const Overlappable by_what_clears_it;
    forget_edits_before(id.c_str());
    edit.changed = ImGui::InputTextWithHint(id.c_str(), shown_hint.c_str(), &text);
  }
  edit.entered = ImGui::IsItemDeactivated() && (key_pressed(Key::enter) || key_pressed(Key::keypad_enter));
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
  const ImVec2 min = ImGui::GetItemRectMin(), max = ImGui::GetItemRectMax();
  if (key_focus().item(full_name(name), min, max, true) && key_focus().pressed()) begun_by_key = full_name(name);
  outline(min, max, ImGui::IsItemActive() ? p.text_quiet : p.line);
  controls().record(name, text);
  style_tooltip(style);
  if (icon == FieldIcon::lens) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImVec2 lens{min.x + px(14), (min.y + max.y) / 2 - px(1)};
    draw.AddCircle(lens, px(4.5), colour_u32(p.text_quiet), 16, px(1.5));
    draw.AddLine({lens.x + px(3), lens.y + px(3)}, {lens.x + px(7), lens.y + px(7)}, colour_u32(p.text_quiet), px(1.5));
  }
  if (text.empty()) return edit;
  const ImVec2 after = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos({start.x + width - clear, start.y});
  const std::string clear_name = std::string(name) + "/clear";
  if (button(clear_name, "×", Emphasis::quiet, {.width = clear})) {
    text.clear();
    edit.changed = true;
  }
  controls().record(clear_name, "clear");
  ImGui::SetCursorScreenPos(after);
  return edit;
}

}  // namespace

bool search_box(std::string_view name, std::string& text, std::string_view hint, const ControlStyle& style) {
  return typed_field(name, text, hint, style, FieldIcon::lens).changed;
}

TextEdit text_field(std::string_view name, std::string& text, std::string_view hint, const ControlStyle& style) {
  return typed_field(name, text, hint, style, FieldIcon::none);
}

}  // namespace ps::gui
