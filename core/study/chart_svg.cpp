#include <cmath>

#include <fmt/format.h>

#include "image/svg.h"
#include "options/option.h"
#include "study/axis.h"
#include "study/chart_files.h"
#include "study/chart_style.h"
#include "study/label_layout.h"

namespace ps {
namespace {

constexpr Vec2d plot_corner{90, 50}, plot_size{830, 450};
constexpr double letter_width = 6.3, letter_height = 13;  // of the 11 px sans-serif used for labels

Vec2d on_plot(const ChartAxes& axes, double time, double error) {
  return {plot_corner.x + plot_size.x * axes.time.place(time),
          plot_corner.y + plot_size.y * (1 - axes.error.place(error))};
}

std::string text_at(double x, double y, std::string_view anchor, std::string_view text, int size = 12) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" font-size=\"{}\">{}</text>\n", x, y, anchor,
                     size, xml_escaped(text));
}

std::string line(Vec2d a, Vec2d b, std::string_view colour, double width) {
  return fmt::format(
      "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\" stroke-width=\"{}\"/>\n", a.x, a.y,
      b.x, b.y, colour, width);
}

std::string draw_axes(const ChartAxes& axes) {
  std::string svg;
  const double bottom = plot_corner.y + plot_size.y;
  for (const Tick& tick : axes.time.ticks()) {
    const double x = plot_corner.x + plot_size.x * axes.time.place(tick.value);
    svg += line({x, plot_corner.y}, {x, bottom}, tick.text.empty() ? "#f0f0f0" : "#d8d8d8", 1);
    if (!tick.text.empty()) svg += text_at(x, bottom + 17, "middle", tick.text);
  }
  for (const Tick& tick : axes.error.ticks()) {
    const double y = plot_corner.y + plot_size.y * (1 - axes.error.place(tick.value));
    svg += line({plot_corner.x, y}, {plot_corner.x + plot_size.x, y}, tick.text.empty() ? "#f0f0f0" : "#d8d8d8", 1);
    if (!tick.text.empty()) svg += text_at(plot_corner.x - 8, y + 4, "end", tick.text);
  }
  svg +=
      text_at(plot_corner.x + plot_size.x / 2, bottom + 40, "middle", "time of one picture (ms), median and quartiles");
  svg += fmt::format(
      "<text transform=\"translate(24 {:.0f}) rotate(-90)\" text-anchor=\"middle\" font-size=\"12\">{}</text>\n",
      plot_corner.y + plot_size.y / 2, xml_escaped(axes.error_title));
  return svg;
}

std::string front_line(const Chart& chart, const ChartAxes& axes) {
  std::string points;
  for (const ChartPoint* point : front_by_time(chart)) {
    const Vec2d place = on_plot(axes, point->time_ms.median, point->error);
    points += fmt::format("{:.1f},{:.1f} ", place.x, place.y);
  }
  return fmt::format("<polyline points=\"{}\" fill=\"none\" stroke=\"#000000\" stroke-width=\"1\" "
                     "stroke-dasharray=\"5 4\"/>\n",
                     points);
}

std::string mark(const ChartPoint& point, const ChartAxes& axes, double largest_memory) {
  const Vec2d at = on_plot(axes, point.time_ms.median, point.error);
  const Vec2d low = on_plot(axes, point.time_ms.q1, point.error), high = on_plot(axes, point.time_ms.q3, point.error);
  const std::string colour = hex_colour(mark_colour(point.what.value));
  const double radius = mark_radius(point.memory_mb, largest_memory);
  std::string svg = line(low, high, colour, 2);
  const std::string title = fmt::format("<title>{}: {:.4g} ms ({:.4g} to {:.4g}), error {:.4g}, {:.4g} MB</title>",
                                        xml_escaped(point.what.settings), point.time_ms.median, point.time_ms.q1,
                                        point.time_ms.q3, point.error, point.memory_mb);
  const std::string_view outline = point.on_front ? "#000000" : "#ffffff";
  if (point.what.value.renderer == Renderer::ray_tracer)
    svg += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\" fill=\"{}\" stroke=\"{}\">{}</circle>\n", at.x,
                       at.y, radius, colour, outline, title);
  else
    svg += fmt::format(
        "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"{}\" stroke=\"{}\">{}</rect>\n",
        at.x - radius, at.y - radius, 2 * radius, 2 * radius, colour, outline, title);
  return svg;
}

std::string labels(const Chart& chart, const ChartAxes& axes) {
  std::vector<LabelWish> wishes;
  std::vector<const ChartPoint*> of_wish;
  for (const ChartPoint& point : chart.points) {
    if (!point.measured()) continue;
    const Vec2d at = on_plot(axes, point.time_ms.median, point.error) - plot_corner;
    const double low = on_plot(axes, point.time_ms.q1, point.error).x - plot_corner.x;
    const double high = on_plot(axes, point.time_ms.q3, point.error).x - plot_corner.x;
    wishes.push_back({at,
                      {letter_width * static_cast<double>(point.what.label.size()), letter_height},
                      point.on_front ? 0 : 1,
                      {at.x - low, high - at.x}});
    of_wish.push_back(&point);
  }
  std::string svg;
  const std::vector<LabelPlace> places = place_labels(wishes, plot_size, largest_mark_radius);
  for (std::size_t i = 0; i < places.size(); ++i)
    if (places[i].shown)
      svg += text_at(plot_corner.x + places[i].corner.x, plot_corner.y + places[i].corner.y + letter_height - 3,
                     "start", of_wish[i]->what.label, 11);
  return svg;
}

}  // namespace

std::string chart_svg(const Chart& chart) {
  const ChartAxes axes = chart_axes(chart);
  const ChartIdentity& id = chart.identity;
  std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"960\" height=\"600\" viewBox=\"0 0 960 600\" "
                    "font-family=\"Inter, Helvetica, Arial, sans-serif\" fill=\"#202020\">\n"
                    "<rect width=\"960\" height=\"600\" fill=\"#ffffff\"/>\n";
  svg += text_at(plot_corner.x, 26, "start",
                 fmt::format("{}, {} x {}: time against error", id.scene, id.width, id.height), 16);
  svg += draw_axes(axes);
  double largest_memory = 0;
  for (const ChartPoint& point : chart.points) largest_memory = std::max(largest_memory, point.memory_mb);
  svg += front_line(chart, axes);
  for (const ChartPoint& point : chart.points)
    if (point.measured()) svg += mark(point, axes, largest_memory);
  svg += labels(chart, axes);
  svg +=
      text_at(plot_corner.x, 562, "start",
              fmt::format("Against: {}. Area of a mark: memory, up to {:.3g} MB. Dashed: the Pareto front. Round: ray "
                          "tracer, square: rasterizer.",
                          id.reference, largest_memory),
              11);
  svg += text_at(plot_corner.x, 582, "start",
                 fmt::format("pixelscope {}, {}, {}, {} threads. {}", chart.machine.version, chart.machine.processor,
                             chart.machine.simd, chart.machine.threads, id.base),
                 11);
  return svg + "</svg>\n";
}

}  // namespace ps
