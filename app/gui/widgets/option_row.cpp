#include <algorithm>
#include <cmath>

#include "gui/widgets/option_parts.h"

namespace ps::gui {
namespace {

constexpr const char* menu = "##menu";

bool differs(const Option& option, const Settings& settings, const OptionRowContext& context) {
  return context.other && option.get(settings) != option.get(*context.other);
}

/// Whether label or choices would be cut in one line; the control then stands below its label.
bool needs_two_lines(const Option& option, float label_width, float control_width) {
  if (option.kind == OptionKind::boolean) return false;
  float widest = 0;
  for (const Choice& choice : option.choices) widest = std::max(widest, text_width(choice.label));
  return text_width(option.label) > label_width - px(6) || widest > control_width - px(28);
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

  // The row's own area: hover, tooltip, right-click.
  ImGui::SetNextItemWidth(room);
  ImGui::PushClipRect(start, {start.x + room, start.y + row_height}, true);
  const bool row_hovered =
      ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(start, {start.x + room, start.y + row_height});
  ImGui::PopClipRect();
  if (context.highlight)
    attention_ring({start.x - px(4), start.y - px(2)}, {start.x + room, start.y + row_height + px(2)});
  if (row_hovered && ImGui::IsMouseReleased(ImGuiMouseButton_Right)) ImGui::OpenPopup(menu);

  if (different) {
    const FontScope bold(Face::bold);
    draw_text({start.x, start.y}, {start.x + mark, start.y + height}, "≠", p.text, 0);
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
  result.request = option_menu(menu, option, settings, context, result.edit);
  ImGui::SetCursorScreenPos(start);
  ImGui::Dummy({room, row_height});
  if (reason || idle_value) {
    result.waking = waking_of(option, settings, traits);
    ImGui::SetCursorScreenPos({start.x + mark, ImGui::GetCursorScreenPos().y});
    if (need_lines(option, result.waking, std::array{context.side}, {}, room - mark))
      result.request = OptionRequest::wake;
  }
  ImGui::PopID();
  return result;
}

}  // namespace ps::gui
