#include "gui/panels/studies/curve_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "gui/base/record.h"
#include "gui/theme/theme.h"
#include "gui/widgets/draw.h"
#include "gui/widgets/screen_painter.h"
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
    const ImVec2 at = window_place(frame.at(row.knob, value));
    const bool joined = curves.figure.quantity->between == Between::values;
    if (last && joined) list.AddLine(*last, at, colour_u32(method_colour(method)), px(2));
    last = at;
  }
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double value = value_of(rows[i], method);
    if (std::isfinite(value)) draw_method_sign(list, window_place(frame.at(rows[i].knob, value)), method, i == strong);
  }
}

/// A band over the knobs where the naive method may be used, with its name.
void draw_safe_window(Painter& painter, const Curves& curves, const PlotFrame& frame) {
  if (curves.safe.empty()) return;
  const PlotAxis& knob = frame.x;
  const double low = std::max(curves.safe.low, knob.zero_place ? 0.0 : knob.low),
               high = std::min(curves.safe.high, knob.high);
  if (!(low <= high)) return;
  const auto& in = frame.inner;
  const double left = curves.safe.low <= knob.low ? in.low.x : frame.at(low, 0).x;
  const double right = curves.safe.high >= knob.high ? in.high.x : frame.at(high, 0).x;
  painter.rectangle({{left, in.low.y}, {right, in.high.y}}, {.fill = Tint{Role::right, 0.14}});
  for (const double x : {left, right}) painter.line({x, in.low.y}, {x, in.high.y}, {{Role::right}});
  const std::string_view text = "safe";
  const double width = painter.extent(text, Lettering::label).width;
  const double least = in.low.x + px(3), most = std::max(least, in.high.x - width - px(3));
  painter.text({std::clamp((left + right - width) / 2, least, most), in.low.y + px(2)}, text,
               {.level = TextLevel::top});
}

std::optional<std::size_t> nearest(const Curves& curves, const PlotFrame& frame, ImVec2 mouse) {
  if (!Area{window_place(frame.inner.low), window_place(frame.inner.high)}.contains(mouse)) return {};
  std::optional<std::size_t> found;
  double best = px(40);
  for (std::size_t i = 0; i < curves.figure.rows.size(); ++i) {
    const double distance = std::abs(frame.at(curves.figure.rows[i].knob, 0).x - mouse.x);
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
  ScreenPainter painter(list);
  drawn.frame = draw_plot_frame(painter, paint_area(plot.min, plot.max), knob_axis(knobs), axis_for(results),
                                {curves.knob, title});
  controls().record("axis", title);
  list.PushClipRect(area.min, area.max, true);
  drawn.cut = curves.names.draw(list, area, mouse);
  draw_safe_window(painter, curves, drawn.frame);
  drawn.hovered = nearest(curves, drawn.frame, mouse);
  const auto strong = drawn.hovered ? drawn.hovered : marked;
  if (strong) {
    const double x = std::round(drawn.frame.at(rows[*strong].knob, 0).x);
    painter.line({x, drawn.frame.inner.low.y}, {x, drawn.frame.inner.high.y}, {{Role::quiet}});
  }
  for (const Method method : {Method::robust, Method::naive}) draw_curve(list, curves, drawn.frame, method, strong);
  controls().record("axis/marked", window_place(drawn.frame.inner.low), window_place(drawn.frame.inner.high),
                    marked ? full_number(rows[*marked].knob) : "none");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const ExperimentFigure::Row& row = rows[i];
    const ImVec2 at = window_place(drawn.frame.at(row.knob, std::isfinite(row.naive) ? row.naive : row.robust));
    controls().record(fmt::format("point/{}", i), {at.x - 2, at.y - 2}, {at.x + 2, at.y + 2},
                      fmt::format("{} {}", full_number(row.naive), full_number(row.robust)));
  }
  list.PopClipRect();
  return drawn;
}

}  // namespace ps::gui
