#include <algorithm>

#include <fmt/format.h>

#include "base/enumerators.h"
#include "image/svg.h"
#include "render/provenance.h"
#include "study/chart_conclusion.h"
#include "study/chart_drawing.h"
#include "study/chart_files.h"
#include "study/chart_style.h"
#include "study/missing_points.h"

namespace ps {
namespace {

constexpr PaintArea chart_paper{{0, 0}, {1000, 700}};
constexpr double paper_margin = 24, title_baseline = 36, legend_top = 50, text_gap = 6;

/// Writes lines from their top left corner and returns where they end.
double write_lines(Painter& painter, const std::vector<std::string>& lines, double top, const TextLook& look) {
  for (const std::string& line : lines) {
    painter.text({paper_margin, top}, line, look);
    top += painter.extent(line, look.lettering).height();
  }
  return top;
}

std::string title_of(const Chart& chart) {
  const ChartIdentity& id = chart.identity;
  const std::string swept = chart_names(chart).common;
  return fmt::format("{}, {} x {}: {} against error{}{}", id.scene, id.width, id.height, enumerator_key(chart.across),
                     swept.empty() ? "" : ", for each value of ", swept);
}

std::string notes_of(const Chart& chart) {
  const ChartIdentity& id = chart.identity;
  const std::size_t missing = missing_points(chart).size();
  return fmt::format("{}{} pixelscope {}, {}, {}, {} threads. {}", chart_provenance(chart),
                     missing == 0 ? "" : fmt::format(" Incomplete: {} of {} points are missing.", missing, id.points),
                     chart.machine.version, chart.machine.processor, chart.machine.simd, chart.machine.threads,
                     id.base);
}

}  // namespace

std::string chart_svg(const Chart& chart) {
  const double left = paper_margin, right = chart_paper.width() - paper_margin, width = right - left;
  const std::string title = title_of(chart);
  SvgPainter svg(chart_paper.width(), chart_paper.height(), title);
  svg.text({left, title_baseline}, title, {.lettering = Lettering::strong});
  const TextLook conclusion_look{.lettering = Lettering::body, .level = TextLevel::top};
  const TextLook notes_look{.level = TextLevel::top, .tint = {Role::quiet}};
  const auto conclusion = lines_of(svg, chart_conclusion(chart).sentence, conclusion_look.lettering, width);
  const auto notes = lines_of(svg, notes_of(chart), notes_look.lettering, width);
  // The plot has the room that the texts leave.
  const auto height = [&](const std::vector<std::string>& lines, const TextLook& look) {
    return static_cast<double>(lines.size()) * svg.extent("0", look.lettering).height() + text_gap;
  };
  const double plot_top = legend_top + chart_legend_height(svg, 2);
  const double plot_end =
      chart_paper.height() - paper_margin - height(conclusion, conclusion_look) - height(notes, notes_look);
  draw_chart_legend(svg, {{left, legend_top}, {right, plot_top}}, chart);
  const PlotFrame frame = draw_chart_frame(svg, {{left, plot_top}, {right, plot_end}}, chart);
  ChartLabels labels;
  draw_chart(svg, chart, frame, place_marks(svg, chart, frame), {}, labels);
  const double end = write_lines(svg, conclusion, plot_end + text_gap, conclusion_look);
  write_lines(svg, notes, end + text_gap, notes_look);
  return svg_with_provenance(svg.finish(), provenance_of(chart.machine, chart.identity.base));
}

}  // namespace ps
