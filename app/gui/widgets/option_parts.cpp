#include "gui/widgets/option_parts.h"

#include <algorithm>

namespace ps::gui {
namespace {

bool differs(const Option& option, const Settings& settings, const OptionRowContext& context) {
  return context.other && option.get(settings) != option.get(*context.other);
}

void paragraph(std::string_view head, std::string_view text) {
  if (text.empty()) return;
  ImGui::Dummy({0, px(1)});
  show_text(std::string(head) + std::string(text), {.quiet = true});
}

}  // namespace

void option_tooltip(const Option& option, const Settings& settings, const OptionRowContext& context,
                    std::string_view reason) {
  if (!begin_tooltip()) return;
  show_text(option.label, {Face::bold});
  show_text(option.help.what);
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

Edit option_control(const Option& option, Settings& settings, const ControlStyle& style, ControlPlace place,
                    const FieldLook& field) {
  const bool in_cell = place == ControlPlace::in_cell;
  double value = option.get(settings);
  Edit edit;
  switch (option.kind) {
  case OptionKind::boolean: {
    bool on = value != 0;
    const std::string_view words = !in_cell ? "" : !style.shown.empty() ? style.shown : on ? "on" : "off";
    if (toggle(option.key, words, on, style)) edit = {true, true};
    value = on ? 1 : 0;
    break;
  }
  case OptionKind::choice: {
    int index = static_cast<int>(value);
    if (drop_down(option.key, option.choices, index, style.width, style, field)) edit = {true, true};
    value = index;
    break;
  }
  case OptionKind::integer:
  case OptionKind::real: {
    const NumberRange range{option.minimum, option.maximum, option.scale, option.kind == OptionKind::integer,
                            in_cell ? "" : option.unit};
    edit = number(option.key, value, range, style);
    break;
  }
  }
  if (edit.changed) option.set(settings, value);
  return edit;
}

void attention_ring(ImVec2 min, ImVec2 max) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float rounding = ImGui::GetStyle().FrameRounding;
  // It may reach into the margins at the left and right of a list that scrolls.
  const ImVec2 low = draw.GetClipRectMin(), high = draw.GetClipRectMax();
  draw.PushClipRect({std::min(low.x, min.x - px(2)), low.y}, {std::max(high.x, max.x + px(2)), high.y});
  draw.AddRect(min, max, colour_u32(palette().text), rounding, 0, px(4));
  draw.AddRect(min, max, colour_u32(palette().attention), rounding, 0, px(2));
  draw.PopClipRect();
}

bool reset_button(const Option& option, float size) {
  const std::string name = std::string(option.key) + "/reset";
  const bool clicked = button(name, "↺", Emphasis::quiet, {.tooltip = "Back to the default", .width = size});
  controls().record(name, "reset");
  return clicked;
}

namespace {

constexpr double need_gap = 8;  // between the text and its buttons

/// How the parts of need_lines() lie; for the small face.
struct NeedLayout {
  std::string text, lines;
  bool has_switch = false;
  bool beside = false;  ///< the buttons are behind the last line, else below it
  float last = 0;       ///< width of the last line
  float lines_height = 0, height = 0;

  float buttons_top() const { return beside ? lines_height - ImGui::GetTextLineHeight() : lines_height; }
};

std::string set_label(std::span<const Side> sides, Side side) {
  return sides.size() == 1 ? "Set" : side == Side::a ? "Set A" : "Set B";
}

NeedLayout need_layout(const Waking& waking, std::span<const Side> sides, std::string_view prefix, float width) {
  NeedLayout layout;
  layout.text = std::string(prefix) + waking_text(waking);
  layout.has_switch = !waking.settings.empty();
  float buttons = 0;
  if (layout.has_switch)
    for (const Side side : sides) buttons += px(need_gap) + button_width(set_label(sides, side));
  layout.lines = in_lines(layout.text, width);
  layout.last = text_width(std::string_view(layout.lines).substr(layout.lines.rfind('\n') + 1));  // npos + 1 is 0
  layout.beside = layout.last + buttons <= width;
  layout.lines_height = text_height(layout.lines);
  layout.height = layout.has_switch ? layout.buttons_top() + ImGui::GetFrameHeight() : layout.lines_height;
  return layout;
}

}  // namespace

float need_lines_height(const Waking& waking, std::span<const Side> sides, std::string_view prefix, float width) {
  const FontScope small(Face::small);
  return need_layout(waking, sides, prefix, width).height;
}

std::optional<Side> need_lines(const Option& option, const Waking& waking, std::span<const Side> sides,
                               std::string_view prefix, float width) {
  const FontScope small(Face::small);
  const NeedLayout layout = need_layout(waking, sides, prefix, width);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float line = ImGui::GetTextLineHeight(), inset = std::floor((ImGui::GetFrameHeight() - line) / 2);
  const bool one_line = layout.lines.find('\n') == std::string::npos;
  // The line that the buttons are behind is as high as they are.
  const std::size_t tail = layout.beside ? layout.lines.rfind('\n') + 1 : layout.lines.size();  // npos + 1 is 0
  draw_lines(at, std::string_view(layout.lines).substr(0, tail), palette().text_quiet);
  draw_lines({at.x, at.y + layout.buttons_top() + inset}, std::string_view(layout.lines).substr(tail),
             palette().text_quiet);
  for (const Side side : sides) {
    const NameScope scope(side == Side::a ? "a" : "b");
    // A button may be at the end of the last line.
    const ImVec2 end{at.x + (one_line ? layout.last : width),
                     at.y + layout.lines_height - (layout.beside && !one_line ? line : 0)};
    controls().record(std::string(option.key) + "/needs", at, end, layout.text);
  }
  std::optional<Side> clicked;
  float x = at.x + (layout.beside ? layout.last + px(need_gap) : 0);
  if (layout.has_switch)
    for (const Side side : sides) {
      const NameScope scope(side == Side::a ? "a" : "b");
      ImGui::SetCursorScreenPos({x, at.y + layout.buttons_top()});
      if (button(std::string(option.key) + "/wake", set_label(sides, side), Emphasis::plain,
                 {.tooltip = "Sets what this option needs. One step back takes it all back."}))
        clicked = side;
      x += button_width(set_label(sides, side)) + px(need_gap);
    }
  ImGui::SetCursorScreenPos(at);
  ImGui::Dummy({width, layout.height});
  return clicked;
}

}  // namespace ps::gui
