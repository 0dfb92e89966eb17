#include "gui/panels/studies/curve_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "gui/theme/theme.h"
#include "gui/widgets/draw.h"
#include "gui/widgets/record.h"
#include "gui/widgets/widgets.h"

namespace ps::gui {
namespace {

constexpr double many_times = 40;  // values that differ by more than this want a logarithmic axis

PlotAxis axis_for(const std::vector<double>& values) {
  double low = INFINITY, high = 0;
  bool negative = false;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    negative = negative || value < 0;
    if (value > 0) low = std::min(low, value);
    high = std::max(high, value);
  }
  const bool logarithmic = !negative && high > many_times * low;
  return fit_axis(values, logarithmic ? AxisScale::logarithmic : AxisScale::linear);
}

/// A lone knob stands in the middle.
PlotAxis knob_axis(const std::vector<double>& knobs) {
  PlotAxis axis = axis_for(knobs);
  const auto [low, high] = std::minmax_element(knobs.begin(), knobs.end());
  if (axis.scale == AxisScale::linear && *low == *high) axis.low = 2 * *low - axis.high;
  return axis;
}

enum class Method { naive, robust };

double value_of(const StabilityRow& row, Method method) {
  switch (method) {
  case Method::naive:
    return row.naive;
  case Method::robust:
    return row.robust;
  }
  return row.naive;
}

void draw_sign(ImDrawList& list, ImVec2 at, Method method, bool strong) {
  const float r = px(strong ? 6 : 4.5), width = px(strong ? 3 : 2);
  switch (method) {
  case Method::naive: {
    const ImU32 ink = colour_u32(palette().wrong_text);
    list.AddLine({at.x - r, at.y - r}, {at.x + r, at.y + r}, ink, width);
    list.AddLine({at.x - r, at.y + r}, {at.x + r, at.y - r}, ink, width);
    break;
  }
  case Method::robust:
    list.AddCircleFilled(at, r, colour_u32(palette().field), 20);
    list.AddCircle(at, r, colour_u32(palette().right_text), 20, width);
    break;
  }
}

const ImVec4& colour_of(Method method) { return method == Method::naive ? palette().wrong_text : palette().right_text; }
ImU32 line_colour(Method method) { return colour_u32(colour_of(method)); }

void draw_curve(ImDrawList& list, const Curves& curves, const PlotFrame& frame, Method method,
                std::optional<std::size_t> strong) {
  std::optional<ImVec2> last;
  for (const StabilityRow& row : curves.rows) {
    const double value = value_of(row, method);
    if (!std::isfinite(value)) {
      last.reset();
      continue;
    }
    const ImVec2 at = frame.at(row.knob, value);
    if (last) list.AddLine(*last, at, line_colour(method), px(2));
    last = at;
  }
  for (std::size_t i = 0; i < curves.rows.size(); ++i) {
    const double value = value_of(curves.rows[i], method);
    if (std::isfinite(value)) draw_sign(list, frame.at(curves.rows[i].knob, value), method, i == strong);
  }
}

/// A band over the knobs where the naive method may be used, with its name.
void draw_safe_window(ImDrawList& list, const Curves& curves, const PlotFrame& frame) {
  if (curves.safe.empty()) return;
  const PlotAxis& knob = frame.x;
  const double low = std::max(curves.safe.low, knob.zero_place ? 0.0 : knob.low),
               high = std::min(curves.safe.high, knob.high);
  if (!(low <= high)) return;
  const auto& in = frame.inner;
  const float left = curves.safe.low <= knob.low ? in.min.x : frame.at(low, 0).x;
  const float right = curves.safe.high >= knob.high ? in.max.x : frame.at(high, 0).x;
  list.AddRectFilled({left, in.min.y}, {right, in.max.y}, colour_u32(palette().right, 0.14));
  for (const float x : {left, right})
    list.AddLine({x, in.min.y}, {x, in.max.y}, colour_u32(palette().right_text), px(1));
  ImFont* font = theme().font(Face::small);
  const char* text = "safe";
  const float width = font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, text).x;
  const float x = std::clamp((left + right - width) / 2, in.min.x + px(3), in.max.x - width - px(3));
  list.AddText(font, font->FontSize, {x, in.min.y + px(2)}, colour_u32(palette().right_text), text);
}

std::string name_of(const Curves& curves, Method method) {
  return method == Method::naive ? "naive: " + curves.naive : "robust: " + curves.robust;
}

float name_width(const std::string& text) {
  ImFont* font = theme().font(Face::small);
  return px(34) + font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, text.c_str()).x;
}

/// Whether both names stand in one line.
bool names_in_line(const Curves& curves, float width) {
  return name_width(name_of(curves, Method::naive)) + name_width(name_of(curves, Method::robust)) <= width;
}

/// Both names above the plot, each behind its sign, in one line or in two. Answers the name under the mouse if it does
/// not fit even so.
std::string draw_names(ImDrawList& list, const Area& area, const Curves& curves, ImVec2 mouse) {
  const FontScope small(Face::small);
  const float height = ImGui::GetFontSize();
  const bool in_line = names_in_line(curves, area.width());
  std::string cut;
  ImVec2 at = area.min;
  for (const Method method : {Method::naive, Method::robust}) {
    const std::string text = name_of(curves, method);
    const Area line{at, {area.max.x, at.y + height + px(2)}};
    if (at.x + name_width(text) - px(18) > area.max.x && line.contains(mouse)) cut = text;
    draw_sign(list, {at.x + px(6), at.y + height / 2}, method, false);
    draw_text({at.x + px(16), at.y}, {area.max.x, at.y + height}, text, colour_of(method), 0);
    if (in_line)
      at.x += name_width(text);
    else
      at.y += height + px(2);
  }
  return cut;
}

std::optional<std::size_t> nearest(const Curves& curves, const PlotFrame& frame, ImVec2 mouse) {
  if (!frame.inner.contains(mouse)) return {};
  std::optional<std::size_t> found;
  float best = px(40);
  for (std::size_t i = 0; i < curves.rows.size(); ++i) {
    const float distance = std::abs(frame.at(curves.rows[i].knob, 0).x - mouse.x);
    if (distance >= best) continue;
    best = distance;
    found = i;
  }
  return found;
}

}  // namespace

CurvesDrawn draw_curves(ImDrawList& list, const Area& area, const Curves& curves, ImVec2 mouse,
                        std::optional<std::size_t> marked) {
  std::vector<double> knobs, results;
  for (const StabilityRow& row : curves.rows) {
    knobs.push_back(row.knob);
    results.insert(results.end(), {row.naive, row.robust});
  }
  const float line = theme().font(Face::small)->FontSize;
  const float names = names_in_line(curves, area.width()) ? line + px(6) : 2 * line + px(8);
  const Area plot{{area.min.x, area.min.y + names}, area.max};
  CurvesDrawn drawn;
  drawn.frame = draw_plot_frame(list, plot, knob_axis(knobs), axis_for(results), {curves.knob, curves.unit});
  list.PushClipRect(area.min, area.max, true);
  drawn.cut = draw_names(list, area, curves, mouse);
  draw_safe_window(list, curves, drawn.frame);
  drawn.hovered = nearest(curves, drawn.frame, mouse);
  const auto strong = drawn.hovered ? drawn.hovered : marked;
  if (strong) {
    const float x = std::round(drawn.frame.at(curves.rows[*strong].knob, 0).x);
    list.AddLine({x, drawn.frame.inner.min.y}, {x, drawn.frame.inner.max.y}, colour_u32(palette().text_quiet));
  }
  for (const Method method : {Method::robust, Method::naive}) draw_curve(list, curves, drawn.frame, method, strong);
  for (std::size_t i = 0; i < curves.rows.size(); ++i) {
    const StabilityRow& row = curves.rows[i];
    const ImVec2 at = drawn.frame.at(row.knob, std::isfinite(row.naive) ? row.naive : row.robust);
    controls().record(fmt::format("point/{}", i), {at.x - 2, at.y - 2}, {at.x + 2, at.y + 2},
                      fmt::format("{} {}", full_number(row.naive), full_number(row.robust)));
  }
  list.PopClipRect();
  return drawn;
}

}  // namespace ps::gui
