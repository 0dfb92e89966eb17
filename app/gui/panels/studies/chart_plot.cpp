#include "gui/panels/studies/chart_plot.h"

#include <fmt/format.h>

#include "gui/base/record.h"
#include "gui/widgets/screen_painter.h"

namespace ps::gui {
namespace {

constexpr double reach = 8;  // pixels around a mark that still hit it, at scale 1

std::optional<std::size_t> nearest(const std::vector<ChartMark>& marks, const Vec2d& mouse) {
  std::optional<std::size_t> found;
  double best = INFINITY;
  for (const ChartMark& mark : marks) {
    const double distance = glm::length(mark.at - mouse);
    if (distance > mark.radius + px(reach) || distance >= best) continue;
    best = distance;
    found = mark.point;
  }
  return found;
}

}  // namespace

std::optional<std::size_t> draw_chart(ImDrawList& list, const Area& area, const Chart& chart, ChartLabels& labels,
                                      const ChartMarks& shown, ImVec2 mouse) {
  ScreenPainter painter(list);
  const PaintArea place = paint_area(area.min, area.max);
  const PlotFrame frame = draw_chart_frame(painter, place, chart);
  const std::vector<ChartMark> marks = place_marks(painter, chart, frame);
  const auto hovered = nearest(marks, paint_place(mouse));
  painter.begin_clip(place);
  ps::draw_chart(painter, chart, frame, marks, {shown.a, shown.b, hovered}, labels);
  painter.end_clip();
  for (const ChartMark& mark : marks) {
    const ImVec2 at = window_place(mark.at);
    const ChartPoint& point = chart.points[mark.point];
    controls().record(fmt::format("point/{}", point.number), {at.x - 2, at.y - 2}, {at.x + 2, at.y + 2},
                      point.what.label);
  }
  return hovered;
}

void draw_planned_mark(ImDrawList& list, const Settings& settings, ImVec2 at, float radius) {
  ScreenPainter painter(list);
  fill_chart_mark(painter, settings, paint_place(at), radius);
}

float chart_legend_height() {
  ImDrawList* const list = ImGui::GetWindowDrawList();
  return static_cast<float>(ps::chart_legend_height(ScreenPainter(*list)));
}

void draw_chart_legend(ImDrawList& list, const Area& area, const Chart& chart) {
  ScreenPainter painter(list);
  ps::draw_chart_legend(painter, paint_area(area.min, area.max), chart);
}

}  // namespace ps::gui
