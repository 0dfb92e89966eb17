#include <algorithm>
#include <cmath>

#include "gui/widgets/draw.h"

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
  if (!reason.empty()) paragraph("Greyed because: ", reason);
  if (differs(option, settings, context))
    paragraph(context.side == Side::a ? "B has: " : "A has: ", option_text(option, *context.other));
  {
    const FontScope mono(Face::mono);
    paragraph("", std::string(option.key) + "=" + option_text(option, settings));
  }
  end_tooltip();
}

/// The right-click menu of a row.
OptionRequest option_menu(const Option& option, Settings& settings, const OptionRowContext& context, Edit& edit) {
  OptionRequest request = OptionRequest::none;
  if (!ImGui::BeginPopup("##menu")) return request;
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

Edit option_control(const Option& option, Settings& settings, const ControlStyle& style) {
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
    if (choice(option.key, option.choices, index, style)) edit = {true, true};
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

/// Whether label or choices would be cut in one line; the control then stands below its label.
bool needs_two_lines(const Option& option, float label_width, float control_width) {
  if (option.kind == OptionKind::boolean) return false;
  float widest = 0;
  for (const Choice& choice : option.choices) widest = std::max(widest, text_width(choice.label));
  return text_width(option.label) > label_width - px(6) || widest > control_width - px(28);
}

/// A round arrow drawn as an arc, shown while the row is not at its default.
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

}  // namespace

OptionRowResult option_row(const Option& option, Settings& settings, const SceneTraits& traits,
                           const OptionRowContext& context) {
  const Palette& p = palette();
  OptionRowResult result;
  const auto reason = inactive_reason(option, settings, traits);
  std::vector<std::string_view> idle;
  for (const Choice& choice : option.choices)
    idle.push_back(inactive_choice_reason(option, choice, settings, traits).value_or(std::string_view{}));
  const auto idle_value = inactive_value_reason(option, settings, traits);
  const ControlStyle base{.disabled = reason.value_or(std::string_view{})};
  ImGui::PushID(full_name(option.key).c_str());
  const ImVec2 start = ImGui::GetCursorScreenPos();
  const float room = ImGui::GetContentRegionAvail().x, height = ImGui::GetFrameHeight();
  const float mark = px(14), reset = px(20);
  float label_width = std::floor(std::clamp((room - mark - reset) * 0.46f, px(90), px(230)));
  if (option.kind == OptionKind::boolean)  // a switch is narrow and can give way to a long label
    label_width = std::min(std::max(label_width, text_width(option.label) + px(10)), room - mark - reset - px(36));
  const bool different = differs(option, settings, context);
  const bool stacked = needs_two_lines(option, label_width, room - mark - label_width - reset);
  std::string label(option.label);
  const bool wrapped = option.kind == OptionKind::boolean && text_width(label) > label_width - px(6);
  if (wrapped) label = in_lines(label, label_width - px(6));
  const float row_height = stacked ? 2 * height : std::max(height, wrapped ? text_height(label) + px(4) : 0);
  ImDrawList& draw = *ImGui::GetWindowDrawList();

  // The row's own area: hover, tooltip, right-click.
  ImGui::SetNextItemWidth(room);
  ImGui::PushClipRect(start, {start.x + room, start.y + row_height}, true);
  const bool row_hovered =
      ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(start, {start.x + room, start.y + row_height});
  ImGui::PopClipRect();
  if (context.highlight)
    draw.AddRectFilled({start.x - px(4), start.y - px(2)}, {start.x + room, start.y + row_height + px(2)},
                       colour_u32(p.attention, 0.45), ImGui::GetStyle().FrameRounding);
  if (row_hovered && ImGui::IsMouseReleased(ImGuiMouseButton_Right)) ImGui::OpenPopup("##menu");

  if (different) {
    const FontScope bold(Face::bold);
    const ImVec4& colour = context.side == Side::a ? p.a_text : p.b_text;
    draw_text({start.x, start.y}, {start.x + mark, start.y + height}, "≠", colour, 0);
  }
  ImGui::SetCursorScreenPos({start.x + mark, start.y});
  const float label_room = stacked ? room - mark : label_width;
  ImGui::Dummy({label_room, stacked ? height : row_height});
  const ImVec4& label_colour = reason || idle_value ? p.text_disabled : p.text;
  if (wrapped)
    draw_lines({start.x + mark, std::floor(start.y + (row_height - text_height(label)) / 2)}, label, label_colour);
  else
    draw_text({start.x + mark, start.y}, {start.x + mark + label_room - px(6), start.y + height}, label, label_colour,
              0);
  option_tooltip(option, settings, context, reason ? *reason : idle_value.value_or(std::string_view{}));

  const ImVec2 place = stacked ? ImVec2{start.x + mark, start.y + height}
                               : ImVec2{start.x + mark + label_width, start.y + (row_height - height) / 2};
  ImGui::SetCursorScreenPos(place);
  ControlStyle style = base;
  style.width = start.x + room - reset - place.x;
  style.idle = idle;
  if (reason) style.tooltip = option.help.what;
  result.edit = option_control(option, settings, style);
  // Words side by side explain themselves one by one; a greyed control says what it is and why not now.
  const bool explained = option.kind == OptionKind::choice && !choices_drop_down(option.choices, style.width);
  if (!explained && !reason) option_tooltip(option, settings, context, idle_value.value_or(std::string_view{}));
  if (option.get(settings) != option.default_value()) {
    ImGui::SetCursorScreenPos({start.x + room - reset, place.y});
    if (reset_button(option, reset)) {
      option.set(settings, option.default_value());
      result.edit = {true, true};
    }
  }
  result.request = option_menu(option, settings, context, result.edit);
  ImGui::SetCursorScreenPos(start);
  ImGui::Dummy({room, row_height});
  ImGui::PopID();
  return result;
}

}  // namespace ps::gui
