#include "gui/widgets/option_pair.h"

#include <algorithm>
#include <cmath>

#include "gui/base/sides.h"
#include "gui/widgets/option_parts.h"

namespace ps::gui {
namespace {

constexpr std::array<const char*, 2> menus{"##menu-a", "##menu-b"};
constexpr double gap = 8;            // between columns, at scale 1
constexpr double wide_enough = 540;  // at scale 1, for labels and values in one line

std::string_view name_of(Side side) { return side == Side::a ? "a" : "b"; }

/// How the values of a row fit its cells.
struct CellForm {
  Face face = Face::body;
  bool stacked = false;  ///< B below A, as not even small print has room side by side
  float height = 0;      ///< of a cell
};

bool fit(std::span<const std::string_view> values, float width) {
  return std::all_of(values.begin(), values.end(),
                     [&](std::string_view value) { return text_width(in_lines(value, width)) <= width; });
}

CellForm form_of(std::span<const std::string_view> values, float cell, float whole) {
  CellForm form{.height = ImGui::GetFrameHeight()};
  float room = drop_down_text_width(cell);
  if (!fit(values, room)) {
    const FontScope small(Face::small);
    if (fit(values, room))
      form.face = Face::small;
    else
      form.stacked = true;
  }
  if (form.stacked) room = drop_down_text_width(whole);
  const FontScope font(form.face);
  for (const std::string_view value : values)
    form.height = std::max(form.height, text_height(in_lines(value, room)) + px(6));
  return form;
}

/// The words that choices show; none for other kinds.
std::vector<std::string_view> words_of(const Option& option, const std::array<Settings, 2>& settings) {
  if (option.kind != OptionKind::choice) return {};
  return {chosen(option, settings[0]).label, chosen(option, settings[1]).label};
}

/// "= Phong"; the sign alone where there is no room for the value.
std::string equal_words(const Option& option, const Settings& settings, float width, Face face) {
  std::string words = "= ";
  switch (option.kind) {
  case OptionKind::boolean:
    return words + (option.get(settings) != 0 ? "on" : "off");
  case OptionKind::choice:
    words += chosen(option, settings).label;
    break;
  case OptionKind::integer:
  case OptionKind::real:
    words += short_number(option.get(settings));
    face = Face::mono;
    break;
  }
  return text_width(words, face) <= drop_down_text_width(width) ? words : "=";
}

/// One picture's value; the words of a choice in lines.
Edit cell(const Option& option, Settings& settings, const ControlStyle& style, const CellForm& form) {
  ControlStyle own = style;
  std::string lines;
  if (option.kind == OptionKind::choice && style.shown.empty()) {
    const FontScope font(form.face);
    lines = in_lines(chosen(option, settings).label, drop_down_text_width(style.width));
    own.shown = lines;
  }
  return option_control(option, settings, own, ControlPlace::in_cell, {form.height, form.face});
}

}  // namespace

OptionColumns option_columns(float room) {
  OptionColumns columns;
  columns.beside_label = room >= px(wide_enough);
  columns.a = columns.beside_label ? std::floor(room * 0.42f) : 0;
  columns.width = std::floor((room - columns.a - px(gap)) / 2);
  columns.b = columns.a + columns.width + px(gap);
  return columns;
}

std::array<OptionRowResult, 2> option_pair(const Option& option, std::array<Settings, 2>& settings,
                                           const SceneTraits& traits, const OptionPairContext& context) {
  const Palette& p = palette();
  std::array<OptionRowResult, 2> results;
  ImGui::PushID(full_name(option.key).c_str());
  const ImVec2 start = ImGui::GetCursorScreenPos();
  const float room = ImGui::GetContentRegionAvail().x, height = ImGui::GetFrameHeight(), reset = px(26);
  const OptionColumns columns = option_columns(room);
  const CellForm form = form_of(words_of(option, settings), columns.width, room);
  const bool a_alone = !context.b_has_none.empty();
  const bool differ = !a_alone && option.get(settings[0]) != option.get(settings[1]);
  const std::array<Waking, 2> waking{waking_of(option, settings[0], traits), waking_of(option, settings[1], traits)};
  const std::array<bool, 2> rests{!waking[0].reason.empty(), !waking[1].reason.empty()};
  const bool both_rest = rests[0] && rests[1];
  const float label_height = columns.beside_label ? form.height : height;
  const float cells_top = columns.beside_label ? start.y : start.y + label_height;
  const float end = cells_top + form.height * (form.stacked ? 2 : 1);
  if (differ)
    ImGui::GetWindowDrawList()->AddRectFilled({start.x - px(5), start.y + px(3)}, {start.x - px(2), end - px(1)},
                                              colour_u32(p.text));

  const std::size_t picked = index_of(context.picked);
  std::array<OptionRowContext, 2> contexts;
  for (std::size_t i = 0; i < 2; ++i) contexts[i] = {.side = both_sides[i], .other = &settings[1 - i]};
  // The label, with the unit of numbers.
  const float label_end = columns.beside_label ? columns.a - px(gap) : room;
  const bool has_reset = option.get(settings[picked]) != option.default_value();
  const float label_room = label_end - (has_reset ? reset : 0);
  ImGui::Dummy({label_room, label_height});
  option_tooltip(option, settings[picked], contexts[picked], waking[picked].reason);
  const ImVec2 label_max{start.x + label_room, start.y + label_height};
  float unit_from = start.x + px(gap);
  const Face face = differ ? Face::bold : Face::body;
  const std::string label = differ ? "≠ " + std::string(option.label) : std::string(option.label);
  draw_text(start, label_max, label, both_rest ? p.text_quiet : p.text, 0, face);
  unit_from += text_width(label, face);
  if (unit_from + text_width(option.unit, Face::small) <= label_max.x)
    draw_text({unit_from, start.y}, label_max, option.unit, p.text_quiet, 1, Face::small);
  if (has_reset) {
    const NameScope scope(name_of(context.picked));
    ImGui::SetCursorScreenPos({start.x + label_end - reset, start.y + (label_height - height) / 2});
    if (reset_button(option, reset)) {
      option.set(settings[picked], option.default_value());
      results[picked].edit = {true, true};
    }
  }

  for (std::size_t i = 0; i < 2; ++i) {
    const NameScope scope(name_of(both_sides[i]));
    const ImVec2 at = form.stacked ? ImVec2{start.x, cells_top + form.height * static_cast<float>(i)}
                                   : ImVec2{start.x + (i == 0 ? columns.a : columns.b), cells_top};
    const float width = form.stacked ? room : columns.width;
    if (a_alone && both_sides[i] == Side::b) {
      ImGui::SetCursorScreenPos(at);
      ImGui::Dummy({width, form.height});
      tooltip(context.b_has_none);
      draw_text({at.x + px(8), at.y}, {at.x + width, at.y + form.height}, "–", p.text_quiet, 0);
      continue;
    }
    ControlStyle style{.width = width};
    style.idle = [&, i](std::size_t choice) {
      return text_of(inactive_choice_reason(option, option.choices[choice], settings[i], traits));
    };
    const std::string disabled = text_of(inactive_reason(option, settings[i], traits));
    style.disabled = disabled;
    std::string same;
    if (i != picked && !differ) style.shown = same = equal_words(option, settings[i], width, form.face);
    ImGui::SetCursorScreenPos(at);
    const Edit edit = cell(option, settings[i], style, form);
    if (edit.changed || edit.finished) results[i].edit = edit;
    if (ImGui::IsWindowHovered() && ImGui::IsMouseReleased(ImGuiMouseButton_Right) &&
        ImGui::IsMouseHoveringRect(at, {at.x + width, at.y + form.height}))
      ImGui::OpenPopup(menus[i]);
    results[i].request = option_menu(menus[i], option, settings[i], contexts[i], results[i].edit);
  }
  ImGui::SetCursorScreenPos(start);
  ImGui::Dummy({room, end - start.y});

  const bool same_need = both_rest && waking_text(waking[0]) == waking_text(waking[1]);
  const auto take = [&](std::optional<Side> clicked) {
    if (!clicked) return;
    const std::size_t i = index_of(*clicked);
    results[i].request = OptionRequest::wake;
    results[i].waking = waking[i];
  };
  if (a_alone)
    take(rests[0] ? need_lines(option, waking[0], std::array{Side::a}, "A ", room) : std::nullopt);
  else if (same_need)
    take(need_lines(option, waking[0], both_sides, {}, room));
  else
    for (std::size_t i = 0; i < 2; ++i)
      if (rests[i]) take(need_lines(option, waking[i], std::array{both_sides[i]}, i == 0 ? "A " : "B ", room));
  ImGui::Dummy({room, px(2)});
  // Round all that the row has, also what it needs.
  const ImVec2 below{start.x + room, ImGui::GetCursorScreenPos().y - ImGui::GetStyle().ItemSpacing.y};
  if (context.highlight) attention_ring({start.x - px(6), start.y - px(2)}, {below.x + px(2), below.y});
  ImGui::PopID();
  return results;
}

}  // namespace ps::gui
