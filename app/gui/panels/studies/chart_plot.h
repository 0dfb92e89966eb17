#pragma once
#include <imgui.h>

#include <optional>

#include "gui/panels/pictures/picture_transform.h"
#include "study/chart_drawing.h"

namespace ps::gui {

/// Draws the measured points of a chart, its axes, front and labels into an area. `mouse` in window pixels. Answers the
/// point under the mouse, by its place in `chart.points`.
std::optional<std::size_t> draw_chart(ImDrawList& list, const Area& area, const Chart& chart, ChartLabels& labels,
                                      const ChartMarks& marks, ImVec2 mouse);

/// The mark that a picture with these settings has in charts.
void draw_planned_mark(ImDrawList& list, const Settings& settings, ImVec2 at, float radius);

/// One line that says what the marks mean, as far as it fits the width.
void draw_chart_legend(ImDrawList& list, const Area& area, const Chart& chart);
float chart_legend_height();

}  // namespace ps::gui
