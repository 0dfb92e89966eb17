#include "gui/widgets/option_parts.h"

#include <cmath>

namespace ps::gui {
namespace {

bool differs(const Option& option, const Settings& settings, const OptionRowContext& context) {
  return context.other && option.get(settings) != option.get(*context.other);
}

void paragraph(std::string_view head, std::string_view text) {
  if (text.empty()) return;
  ImGui::Dummy({0, px(1)});
  ImGui::PushStyleColor(ImGuiCol_Text, palette().text_quiet);
  const std::string line = std::string(head) + std::string(text);
  ImGui::TextUnformatted(line.c_str());
  ImGui::PopStyleColor();
}

}  // namespace

void option_tooltip(const Option& option, const Settings& settings, const OptionRowContext& context,
                    std::string_view reason) {
  if (!begin_tooltip()) return;
  {
    const FontScope bold(Face::bold);
    ImGui::TextUnformatted(option.label.data(), option.label.data() + option.label.size());
  }
  ImGui::TextUnformatted(option.help.what.data(), option.help.what.data() + option.help.what.size());
  if (option.kind == OptionKind::choice) {
    const Choice& now = chosen(option, settings);
    paragraph(std::string(now.label) + ": ", now.help);
  }
  paragraph("How it fails: ", option.help.fails);
  paragraph("Source: ", option.help.source);
  if (!reason.empty()) paragraph("Not now: ", reason);
  if (differs(option, settings, context))
    paragraph(context.side == Side::a ? "B has: " : "A has: ", option_text(option, *context.other));
  {
    const FontScope mono(Face::mono);
    paragraph("", std::string(option.key) + "=" + option_text(option, settings));
  }
  end_tooltip();
}

OptionRequest option_menu(const char* popup, const Option& option, Settings& settings, const OptionRowContext& context,
                          Edit& edit) {
  OptionRequest request = OptionRequest::none;
  if (!ImGui::BeginPopup(popup)) return request;
  const NameScope names(std::string(option.key) + "/menu");
  const std::string assignment = std::string(option.key) + "=" + option_text(option, settings);
  const bool is_default = option.get(settings) == option.default_value();
  const bool to_b = context.side == Side::a;
  if (menu_item("copy", "Copy " + assignment)) ImGui::SetClipboardText(assignment.c_str());
  if (menu_item("reset", "Reset to default", {}, false, is_default ? "it has its default" : "")) {
    option.set(settings, option.default_value());
    edit = {true, true};
  }
  if (menu_item("send", to_b ? "Send this value to B" : "Send this value to A")) request = OptionRequest::send_to_other;
  if (menu_item("only", to_b ? "B = A except this option" : "A = B except this option"))
    request = OptionRequest::only_difference;
  if (menu_item("sweep", "Sweep it in a chart")) request = OptionRequest::sweep;
  ImGui::EndPopup();
  return request;
}

Edit option_control(const Option& option, Settings& settings, const ControlStyle& style, ChoiceForm form) {
  Edit edit;
  const double before = option.get(settings);
  switch (option.kind) {
  case OptionKind::boolean: {
    bool on = before != 0;
    if (toggle(option.key, {}, on, style)) edit = {true, true};
    if (edit.changed) option.set(settings, on ? 1 : 0);
    break;
  }
  case OptionKind::choice: {
    int index = static_cast<int>(before);
    const bool changed = form == ChoiceForm::drop_down
                             ? drop_down(option.key, option.choices, index, style.width, style)
                             : choice(option.key, option.choices, index, style);
    if (changed) edit = {true, true};
    if (edit.changed) option.set(settings, index);
    break;
  }
  case OptionKind::integer:
  case OptionKind::real: {
    double value = before;
    const NumberRange range{option.minimum, option.maximum, option.scale, option.kind == OptionKind::integer,
                            option.unit};
    edit = number(option.key, value, range, style);
    if (edit.changed) option.set(settings, value);
    break;
  }
  }
  return edit;
}

void attention_ring(ImVec2 min, ImVec2 max) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float rounding = ImGui::GetStyle().FrameRounding;
  draw.AddRect(min, max, colour_u32(palette().text), rounding, 0, px(4));
  draw.AddRect(min, max, colour_u32(palette().attention), rounding, 0, px(2));
}

bool reset_button(const Option& option, float size) {
  const std::string name = std::string(option.key) + "/reset";
  const bool clicked = hit_area(name, {size, ImGui::GetFrameHeight()}, {});
  const ImVec2 min = ImGui::GetItemRectMin(), max = ImGui::GetItemRectMax();
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const ImVec2 middle{(min.x + max.x) / 2, (min.y + max.y) / 2};
  const ImU32 ink = colour_u32(ImGui::IsItemHovered() ? palette().text : palette().text_quiet);
  const float radius = px(4.5);
  draw.PathArcTo(middle, radius, -2.2f, 3.1f, 16);
  draw.PathStroke(ink, 0, px(1.5));
  const ImVec2 tip{middle.x + radius * std::cos(-2.2f), middle.y + radius * std::sin(-2.2f)};
  draw.AddTriangleFilled({tip.x - px(3), tip.y + px(2.5)}, {tip.x - px(2), tip.y - px(3)}, {tip.x + px(3), tip.y}, ink);
  controls().record(name, "reset");
  tooltip("Back to the default");
  return clicked;
}

std::optional<Side> need_lines(const Option& option, const Waking& waking, std::span<const Side> sides,
                               std::string_view prefix, float width) {
  const FontScope small(Face::small);
  const std::string text = std::string(prefix) + waking_text(waking);
  const bool has_switch = !waking.settings.empty();
  const float gap = px(8);
  float buttons = 0;
  const auto label_of = [&](Side side) { return sides.size() == 1 ? "Set" : side == Side::a ? "Set A" : "Set B"; };
  if (has_switch)
    for (const Side side : sides) buttons += gap + button_width(label_of(side));
  // Beside the last line if there is room, else below it.
  const std::string lines = in_lines(text, width);
  const std::string_view last = std::string_view(lines).substr(lines.rfind('\n') + 1);  // npos + 1 is 0
  const bool beside = text_width(last) + buttons <= width;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float line = ImGui::GetTextLineHeight(), height = text_height(lines), button_height = ImGui::GetFrameHeight();
  const float inset = std::floor((button_height - line) / 2);
  draw_lines({at.x, at.y + (beside ? inset : 0)}, lines, palette().text_quiet);
  for (const Side side : sides) {
    const NameScope scope(side == Side::a ? "a" : "b");
    // A button may stand at the end of the last line.
    const bool one_line = lines.find('\n') == std::string::npos;
    const ImVec2 end{at.x + (one_line ? text_width(last) : width),
                     at.y + (beside && !one_line ? height - line : height)};
    controls().record(std::string(option.key) + "/needs", at, end, text);
  }
  std::optional<Side> clicked;
  float x = at.x + (beside ? text_width(last) + gap : 0);
  const float y = at.y + (beside ? height - line : height);
  if (has_switch)
    for (const Side side : sides) {
      const NameScope scope(side == Side::a ? "a" : "b");
      ImGui::SetCursorScreenPos({x, y});
      if (button(std::string(option.key) + "/wake", label_of(side), Emphasis::plain,
                 {.tooltip = "Sets what this option needs. One step back takes it all back."}))
        clicked = side;
      x += button_width(label_of(side)) + gap;
    }
  ImGui::SetCursorScreenPos(at);
  ImGui::Dummy({width, has_switch ? y + button_height - at.y : height});
  return clicked;
}

}  // namespace ps::gui
