#include "gui/panels/pictures/legend_range.h"

#include <algorithm>
#include <cmath>

#include "gui/widgets/widgets.h"
#include "image/heat_colour.h"

namespace ps::gui {
namespace {

constexpr int bar_steps = 60;          // of the bar's colours
constexpr double least_window = 0.01;  // of the bar, between the two handles

bool is_asked(const Session& session, Side side) {
  const auto& asked = session.document().heat_range;
  return asked && asked->channel == session.shown(side);
}

/// The range that the pictures' values have by themselves.
ValueRange usual_range(Session& session, PicturesState& state, Side side, const ChannelLegend& legend) {
  UsualRange& known = state.sides.usual[index_of(side)];
  const auto result = session.renderer(side).result();
  if (!is_asked(session, side))
    known = {result, session.shown(side), {legend.low, legend.high}};
  else if (result && (known.result != result || known.channel != session.shown(side)))
    known = {result, session.shown(side), channel_range(result->frame, session.shown(side)).value_or(ValueRange{})};
  ValueRange range = known.values;
  if (!(range.high > range.low)) range.high = range.low + 1;
  return range;
}

void ask_for(Session& session, Side side, ValueRange range) {
  if (!(range.high > range.low)) return;
  session.navigate([&](Document& document) { document.heat_range = HeatRange{session.shown(side), range}; });
}

void draw_bar(const Area& bar, const ValueRange& whole, const ValueRange& shown) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (int i = 0; i < bar_steps; ++i) {
    const double value = whole.low + (whole.high - whole.low) * (i + 0.5) / bar_steps;
    const Rgb8 c = heat_colour((value - shown.low) / (shown.high - shown.low));
    const auto at = [&](int step) { return bar.min.x + bar.width() * static_cast<float>(step) / bar_steps; };
    list.AddRectFilled({at(i), bar.min.y}, {at(i + 1), bar.max.y}, IM_COL32(c.r, c.g, c.b, 255));
  }
}

/// Answers the value that the handle was dragged to.
std::optional<double> handle(const char* name, const Area& bar, const ValueRange& whole, double value) {
  const double share = std::clamp((value - whole.low) / (whole.high - whole.low), 0.0, 1.0);
  const float x = std::round(bar.min.x + bar.width() * static_cast<float>(share)), half = px(6);
  ImGui::SetCursorScreenPos({x - half, bar.min.y - px(3)});
  ImGui::InvisibleButton(full_name(name).c_str(), {2 * half, bar.height() + px(6)});
  controls().record(name, short_number(value));
  const bool held = ImGui::IsItemActive();
  if (held || ImGui::IsItemHovered()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 low{x - px(3), bar.min.y - px(3)}, high{x + px(3), bar.max.y + px(3)};
  list.AddRectFilled(low, high, colour_u32(palette().panel), px(2));
  list.AddRect(low, high, colour_u32(palette().text), px(2), ImDrawFlags_None, held ? px(2) : px(1));
  tooltip("Drag: values beyond this end have its colour.");
  if (!held || ImGui::GetIO().MouseDelta.x == 0) return {};
  const double at = (ImGui::GetIO().MousePos.x - bar.min.x) / std::max(bar.width(), 1.f);
  return whole.low + std::clamp(at, 0.0, 1.0) * (whole.high - whole.low);
}

}  // namespace

void legend_range(Session& session, PicturesState& state, Side side, const ChannelLegend& legend,
                  const LegendScale& scale) {
  const NameScope names(side == Side::a ? "view/a/range" : "view/b/range");
  const ValueRange usual = usual_range(session, state, side, legend);
  ValueRange shown{legend.low, legend.high};
  if (!(shown.high > shown.low)) shown.high = shown.low + 1;
  const ValueRange whole{std::min(usual.low, shown.low), std::max(usual.high, shown.high)};
  draw_bar(scale.bar, whole, shown);
  const double least = (whole.high - whole.low) * least_window;
  if (const auto low = handle("handle/low", scale.bar, whole, shown.low))
    ask_for(session, side, {std::min(*low, shown.high - least), shown.high});
  if (const auto high = handle("handle/high", scale.bar, whole, shown.high))
    ask_for(session, side, {shown.low, std::max(*high, shown.low + least)});

  const float width = px(84), space = px(4);
  const double reach = whole.high - whole.low;
  const NumberRange range{.minimum = whole.low - reach, .maximum = whole.high + reach};
  ImGui::SetCursorScreenPos(scale.numbers.min);
  if (number("low", shown.low, range, {.tooltip = "Values up to this have the first colour.", .width = width}).changed)
    ask_for(session, side, shown);
  ImGui::SameLine(0, space);
  if (button_on_off(
          "auto", "auto", !is_asked(session, side),
          {.tooltip = "The range of the pictures' own values.", .width = scale.numbers.width() - 2 * (width + space)}))
    session.navigate([&](Document& document) {
      document.heat_range = is_asked(session, side)
                                ? std::nullopt
                                : std::optional(HeatRange{session.shown(side), {legend.low, legend.high}});
    });
  ImGui::SameLine(0, space);
  if (number("high", shown.high, range, {.tooltip = "Values from this on have the last colour.", .width = width})
          .changed)
    ask_for(session, side, shown);
}

}  // namespace ps::gui
