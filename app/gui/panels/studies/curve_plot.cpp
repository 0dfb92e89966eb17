#include "gui/panels/studies/curve_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "gui/base/record.h"
#include "gui/theme/theme.h"
#include "gui/widgets/draw.h"
#include "gui/widgets/widgets.h"

namespace ps::gui {
namespace {

constexpr double many_times_wider = 40;  // values that differ by more than this want a logarithmic axis

PlotAxis axis_for(const std::vector<double>& values) {
  double low = INFINITY, high = 0;
  bool negative = false;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    negative = negative || value < 0;
    if (value > 0) low = std::min(low, value);
    high = std::max(high, value);
  }
  const bool logarithmic = !negative && high > many_times_wider * low;
  return fit_axis(values, logarithmic ? AxisScale::logarithmic : AxisScale::linear);
}

/// A lone knob is in the middle.
PlotAxis knob_axis(const std::vector<double>& knobs) {
  PlotAxis axis = axis_for(knobs);
  const auto [low, high] = std::minmax_element(knobs.begin(), knobs.end());
  if (axis.scale == AxisScale::linear && *low == *high) axis.low = 2 * *low - axis.high;
  return axis;
}

double value_of(const ExperimentFigure::Row& row, Method method) {
  return method == Method::naive ? row.naive : row.robust;
}

void draw_curve(ImDrawList& list, const Curves& curves, const PlotFrame& frame, Method method,
                std::optional<std::size_t> strong) {
  const auto& rows = curves.figure.rows;
  std::optional<ImVec2> last;
  for (const ExperimentFigure::Row& row : rows) {
    const double value = value_of(row, method);
    if (!std::isfinite(value)) {
      last.reset();
      continue;
    }
    const ImVec2 at = frame.at(row.knob, value);
    const bool joined = curves.figure.quantity->between == Between::values;
    if (last && joined) list.AddLine(*last, at, colour_u32(method_colour(method)), px(2));
    last = at;
  }
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double value = value_of(rows[i], method);
    if (std::isfinite(value)) draw_method_sign(list, frame.at(rows[i].knob, value), method, i == strong);
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
    list.AddLine({x, in.min.y}, {x, in.max.y}, colour_u32(palette().right_mark), px(1));
  ImFont* font = theme().font(Face::small);
  const char* text = "safe";
  const float width = font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, text).x;
  const float least = in.min.x + px(3), most = std::max(least, in.max.x - width - px(3));
  const float x = std::clamp((left + right - width) / 2, least, most);
  list.AddText(font, font->FontSize, {x, in.min.y + px(2)}, colour_u32(palette().text), text);
}

std::optional<std::size_t> nearest(const Curves& curves, const PlotFrame& frame, ImVec2 mouse) {
  if (!frame.inner.contains(mouse)) return {};
  std::optional<std::size_t> found;
  float best = px(40);
  for (std::size_t i = 0; i < curves.figure.rows.size(); ++i) {
    const float distance = std::abs(frame.at(curves.figure.rows[i].knob, 0).x - mouse.x);
    if (distance >= best) continue;
    best = distance;
    found = i;
  }
  return found;
}

}  // namespace

CurvesDrawn draw_curves(ImDrawList& list, const Area& area, const Curves& curves, ImVec2 mouse,
                        std::optional<std::size_t> marked) {
  const auto& rows = curves.figure.rows;
  std::vector<double> knobs, results;
  for (const ExperimentFigure::Row& row : rows) {
    knobs.push_back(row.knob);
    results.insert(results.end(), {row.naive, row.robust});
  }
  const Area plot{{area.min.x, area.min.y + curves.names.height(area.width())}, area.max};
  CurvesDrawn drawn;
  const std::string title = curves.figure.axis_title();
  drawn.frame = draw_plot_frame(list, plot, knob_axis(knobs), axis_for(results), {curves.knob, title});
  controls().record("axis", title);
  list.PushClipRect(area.min, area.max, true);
  drawn.cut = curves.names.draw(list, area, mouse);
  draw_safe_window(list, curves, drawn.frame);
  drawn.hovered = nearest(curves, drawn.frame, mouse);
  const auto strong = drawn.hovered ? drawn.hovered : marked;
  if (strong) {
    const float x = std::round(drawn.frame.at(rows[*strong].knob, 0).x);
    list.AddLine({x, drawn.frame.inner.min.y}, {x, drawn.frame.inner.max.y}, colour_u32(palette().text_quiet));
  }
  for (const Method method : {Method::robust, Method::naive}) draw_curve(list, curves, drawn.frame, method, strong);
  controls().record("axis/marked", drawn.frame.inner.min, drawn.frame.inner.max,
                    marked ? full_number(rows[*marked].knob) : "none");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const ExperimentFigure::Row& row = rows[i];
    const ImVec2 at = drawn.frame.at(row.knob, std::isfinite(row.naive) ? row.naive : row.robust);
    controls().record(fmt::format("point/{}", i), {at.x - 2, at.y - 2}, {at.x + 2, at.y + 2},
                      fmt::format("{} {}", full_number(row.naive), full_number(row.robust)));
  }
  list.PopClipRect();
  return drawn;
}

}  // namespace ps::gui
