#include "gui/panels/lesson/option_field.h"

#include <fmt/format.h>

#include <algorithm>

#include "gui/panels/options/row_results.h"
#include "gui/widgets/draw.h"
#include "gui/widgets/option_parts.h"
#include "gui/widgets/widgets.h"

namespace ps::gui {
namespace {

float letter_width() { return px(22); }

float value_width(const Option& option) {
  float width = px(112);  // for the longest numbers
  switch (option.kind) {
  case OptionKind::boolean:
    return px(36);
  case OptionKind::choice:
    for (const Choice& choice : option.choices) width = std::max(width, text_width(choice.label) + px(30));
    return width;
  case OptionKind::integer:
  case OptionKind::real:
    return width + (option.unit.empty() ? 0 : text_width(option.unit));
  }
  return width;
}

}  // namespace

float option_field_width(const Option& option) { return letter_width() + value_width(option) + px(4); }

void option_field(Session& session, Side side, const Option& option, float width) {
  const NameScope scope(side == Side::a ? "a" : "b");
  const ImVec2 at = ImGui::GetCursorScreenPos();
  {
    const FontScope font(Face::bold);
    const float height = ImGui::GetFrameHeight();
    side_bar(*ImGui::GetWindowDrawList(), {at.x, at.y + px(4)}, {at.x + px(3), at.y + height - px(4)}, side);
    draw_text({at.x + px(6), at.y}, {at.x + letter_width(), at.y + height}, std::string(1, letter_of(side)),
              palette().text, 0);
  }
  Settings settings = session.settings(side);
  const std::string reason = text_of(inactive_reason(option, settings, session.traits()));
  const std::string help = fmt::format("{}: {}", option.label, option.help.what);
  ImGui::SetCursorScreenPos({at.x + letter_width(), at.y});
  OptionRowResult result;
  result.edit = option_control(
      option, settings, {.tooltip = help, .disabled = reason, .width = width - letter_width() - px(4), .idle = {}},
      ControlPlace::in_text);
  take_row_result(session, side, option, settings, result);
}

}  // namespace ps::gui
