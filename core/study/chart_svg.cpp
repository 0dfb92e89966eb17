#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "image/svg.h"
#include "options/option.h"
#include "options/renderer_kind.h"
#include "render/provenance.h"
#include "study/axis.h"
#include "study/chart_conclusion.h"
#include "study/chart_files.h"
#include "study/chart_front.h"
#include "study/chart_style.h"
#include "study/counted_work.h"
#include "study/label_layout.h"
#include "study/missing_points.h"

namespace ps {
namespace {

constexpr double paper_width = 1000, paper_height = 700;
constexpr Vec2d plot_corner{92, 92}, plot_size{880, 448};
constexpr int title_size = 20, axis_size = 15, tick_size = 14, label_size = 14, conclusion_size = 15, note_size = 11;

/// About how wide a text is in a sans-serif face of that size: a file cannot measure the face it is shown in.
double estimated_width(std::string_view text, double size) {
  double width = 0;
  for (const char c : text) {
    const bool narrow = std::string_view("ijlt.,:;'|!()[]f1 -").find(c) != std::string_view::npos;
    const bool wide = std::string_view("mwMW%@").find(c) != std::string_view::npos;
    width += narrow ? 0.35 : wide ? 0.88 : c >= 'A' && c <= 'Z' ? 0.7 : 0.6;
  }
  return width * size;
}

Vec2d on_plot(const ChartAxes& axes, double cost, double error) {
  return {plot_corner.x + plot_size.x * axes.cost.place(cost),
          plot_corner.y + plot_size.y * (1 - axes.error.place(error))};
}

std::string text_at(double x, double y, std::string_view anchor, std::string_view text, int size,
                    std::string_view more = "") {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" font-size=\"{}\"{}>{}</text>\n", x, y, anchor,
                     size, more, xml_escaped(text));
}

std::string line(Vec2d a, Vec2d b, std::string_view colour, double width, std::string_view more = "") {
  return fmt::format(
      "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\" stroke-width=\"{}\"{}/>\n", a.x, a.y,
      b.x, b.y, colour, width, more);
}

std::string draw_axes(const ChartAxes& axes) {
  std::string svg;
  const double bottom = plot_corner.y + plot_size.y, right = plot_corner.x + plot_size.x;
  const auto shade = [](const Tick& tick) { return tick.text.empty() ? "#efefef" : "#d4d4d4"; };
  for (const Tick& tick : axes.cost.ticks()) {
    const double x = plot_corner.x + plot_size.x * axes.cost.place(tick.value);
    svg += line({x, plot_corner.y}, {x, bottom}, shade(tick), 1);
    if (!tick.text.empty()) svg += text_at(x, bottom + 20, "middle", tick.text, tick_size);
  }
  for (const Tick& tick : axes.error.ticks()) {
    const double y = plot_corner.y + plot_size.y * (1 - axes.error.place(tick.value));
    svg += line({plot_corner.x, y}, {right, y}, shade(tick), 1);
    if (!tick.text.empty()) svg += text_at(plot_corner.x - 8, y + 5, "end", tick.text, tick_size);
  }
  svg += line({plot_corner.x, bottom}, {right, bottom}, "#606060", 1.5);
  svg += line({plot_corner.x, plot_corner.y}, {plot_corner.x, bottom}, "#606060", 1.5);
  if (const auto place = axes.error.break_place()) {
    const double y = plot_corner.y + plot_size.y * (1 - *place);
    for (const double side : {-3.0, 3.0})
      svg += line({plot_corner.x - 6, y + side + 3}, {plot_corner.x + 6, y + side - 3}, "#202020", 1.5);
  }
  svg += text_at(plot_corner.x + plot_size.x / 2, bottom + 44, "middle",
                 fmt::format("{}{}; left is cheaper", axes.cost_title, axes.cost_spread), axis_size);
  svg += fmt::format("<text transform=\"translate(24 {:.0f}) rotate(-90)\" text-anchor=\"middle\" "
                     "font-size=\"{}\">{}</text>\n",
                     plot_corner.y + plot_size.y / 2, axis_size, xml_escaped(axes.error_title + axes.error_sense));
  return svg;
}

/// The front as steps on the plot, from its upper edge to its right one.
std::vector<Vec2d> front_on_plot(const Chart& chart, const ChartAxes& axes) {
  std::vector<Vec2d> corners;
  for (const Vec2d& corner : front_staircase(chart)) corners.push_back(on_plot(axes, corner.x, corner.y));
  if (corners.empty()) return corners;
  const bool up = error_metric(chart.metric).higher_is_better;
  corners.insert(corners.begin(), {corners.front().x, up ? plot_corner.y + plot_size.y : plot_corner.y});
  corners.emplace_back(plot_corner.x + plot_size.x, corners.back().y);
  return corners;
}

std::string front_line(const Chart& chart, const ChartAxes& axes) {
  std::string points;
  for (const Vec2d& place : front_on_plot(chart, axes)) points += fmt::format("{:.1f},{:.1f} ", place.x, place.y);
  return fmt::format("<polyline points=\"{}\" fill=\"none\" stroke=\"#000000\" stroke-width=\"2\" "
                     "stroke-dasharray=\"7 5\"/>\n",
                     points);
}

constexpr std::string_view band_look = "fill=\"#000000\" fill-opacity=\"0.09\"";

std::string uncertain_band(const Chart& chart, const ChartAxes& axes) {
  std::string svg;
  for (const FrontBandPart& part : front_band(chart)) {
    const Vec2d a = on_plot(axes, part.cost_from, part.error.best), b = on_plot(axes, part.cost_to, part.error.worst);
    svg += fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" {}/>\n", a.x,
                       std::min(a.y, b.y), b.x - a.x, std::abs(a.y - b.y), band_look);
  }
  return svg;
}

/// `words` are shown to a pointer over it.
std::string sign(Renderer renderer, Vec2d at, double radius, std::string_view look, std::string_view words) {
  const std::string rest = fmt::format("{}><title>{}</title>", look, xml_escaped(words));
  switch (mark_shape(renderer)) {
  case MarkShape::circle:
    return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\" {}</circle>\n", at.x, at.y, radius, rest);
  case MarkShape::square:
    return fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" {}</rect>\n", at.x - radius,
                       at.y - radius, 2 * radius, 2 * radius, rest);
  case MarkShape::diamond:
    return fmt::format("<polygon points=\"{:.1f},{:.1f} {:.1f},{:.1f} {:.1f},{:.1f} {:.1f},{:.1f}\" {}</polygon>\n",
                       at.x, at.y - radius, at.x + radius, at.y, at.x, at.y + radius, at.x - radius, at.y, rest);
  case MarkShape::triangle:
    return fmt::format("<polygon points=\"{:.1f},{:.1f} {:.1f},{:.1f} {:.1f},{:.1f}\" {}</polygon>\n", at.x,
                       at.y - radius, at.x + radius, at.y + radius, at.x - radius, at.y + radius, rest);
  }
  return {};
}

/// A dotted line below the mark, from its middle to where that would lie with the upload of the scene.
std::string upload_bar(const Chart& chart, const ChartPoint& point, const ChartAxes& axes) {
  const auto whole = cost_with_upload(chart, point);
  if (!whole) return "";
  const std::string colour = hex_colour(mark_colour(point.what.value));
  Vec2d from = on_plot(axes, point.cost.median, point.error), to = on_plot(axes, *whole, point.error);
  from.y = to.y = from.y + largest_mark_radius + 6;
  return line(from, to, colour, 2, " stroke-dasharray=\"2 4\"") + line(to - Vec2d(0, 7), to + Vec2d(0, 7), colour, 2);
}

std::string error_text(const ChartPoint& point) {
  switch (point.standing) {
  case Standing::compared:
    return fmt::format("error {:.4g}", point.error);
  case Standing::truth:
    return "the truth itself";
  case Standing::other_picture:
    return fmt::format("another picture on purpose, different by {:.4g}", point.error);
  }
  return "";
}

std::string truth_ring(Vec2d at, double radius, std::string_view colour) {
  return fmt::format("<path d=\"M {0:.1f} {1:.1f} a {2:.1f} {2:.1f} 0 1 0 {3:.1f} 0 a {2:.1f} {2:.1f} 0 1 0 -{3:.1f} "
                     "0\" fill=\"none\" stroke=\"{4}\" stroke-width=\"1.5\"/>\n",
                     at.x - radius, at.y, radius, 2 * radius, colour);
}

std::string mark(const ChartPoint& point, const ChartAxes& axes, double largest_memory) {
  const Vec2d at = on_plot(axes, point.cost.median, point.error);
  const Vec2d low = on_plot(axes, point.cost.q1, point.error), high = on_plot(axes, point.cost.q3, point.error);
  const std::string colour = hex_colour(mark_colour(point.what.value));
  std::string svg = line(low, high, colour, 2);
  for (const Vec2d& end : {low, high}) svg += line(end - Vec2d(0, 4), end + Vec2d(0, 4), colour, 2);
  const bool hollow = point.tie || !point.ranked();
  const std::string look = fmt::format("fill=\"{}\" stroke=\"{}\" stroke-width=\"{}\"", hollow ? "#ffffff" : colour,
                                       hollow           ? colour
                                       : point.on_front ? "#000000"
                                                        : "#ffffff",
                                       point.on_front || hollow ? 2 : 1);
  const std::string words =
      fmt::format("{}: {:.4g} ms ({:.4g} to {:.4g}), work {}, {}, {:.4g} MB", point.what.settings, point.time_ms.median,
                  point.time_ms.q1, point.time_ms.q3, work_text(point.work), error_text(point), point.memory_mb);
  const double radius = mark_radius(point.memory_mb, largest_memory);
  if (point.standing == Standing::truth) svg += truth_ring(at, radius + truth_ring_gap, colour);
  return svg + sign(point.what.value.renderer, at, radius, look, words);
}

std::string labels(const Chart& chart, const ChartAxes& axes) {
  const SweepNames names = chart_names(chart);
  std::vector<LabelWish> wishes;
  std::vector<const ChartPoint*> of_wish;
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < chart.points.size(); ++i) {
    const ChartPoint& point = chart.points[i];
    if (!point.placed()) continue;
    texts.push_back(mark_label(chart, point, names.parts[i]));
    const Vec2d at = on_plot(axes, point.cost.median, point.error) - plot_corner;
    const double low = on_plot(axes, point.cost.q1, point.error).x - plot_corner.x;
    const double right = std::max(point.cost.q3, cost_with_upload(chart, point).value_or(0));
    const double high = on_plot(axes, right, point.error).x - plot_corner.x;
    wishes.push_back({at,
                      {estimated_width(texts.back(), label_size), label_size + 2},
                      point.on_front ? 0 : 1,
                      {at.x - low, high - at.x}});
    of_wish.push_back(&point);
  }
  std::vector<LabelLine> front;
  const std::vector<Vec2d> steps = front_on_plot(chart, axes);
  for (std::size_t i = 1; i < steps.size(); ++i) front.emplace_back(steps[i - 1] - plot_corner, steps[i] - plot_corner);
  std::string lines, words;
  const std::vector<LabelPlace> places = place_labels(wishes, plot_size, largest_mark_radius, front);
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!places[i].shown) continue;
    if (const auto leader = label_leader(wishes[i], places[i], largest_mark_radius))
      lines += line(plot_corner + leader->first, plot_corner + leader->second, "#909090", 1);
    // A white rim keeps it legible where a line runs behind it. It is a text of its own: not every program that shows
    // SVG knows paint-order, and without it the rim would cover the letters.
    const char* const colour = of_wish[i]->on_front ? "#202020" : "#606060";
    for (const std::string& look :
         {std::string(" stroke=\"#ffffff\" stroke-width=\"3\" fill=\"#ffffff\""), fmt::format(" fill=\"{}\"", colour)})
      words += text_at(plot_corner.x + places[i].corner.x, plot_corner.y + places[i].corner.y + label_size - 1, "start",
                       texts[i], label_size, look);
  }
  return lines + words;
}

/// The legend: what each colour, shape and line in the chart means.
std::string legend(const Chart& chart, double largest_memory) {
  constexpr double y = plot_corner.y - 24;
  double x = plot_corner.x;
  std::string svg;
  const auto words = [&](const std::string& text) {
    svg += text_at(x, y + 5, "start", text, tick_size);
    x += estimated_width(text, tick_size) + 22;
  };
  std::vector<std::string> named;
  for (const ChartPoint& point : chart.points) {
    const Settings& value = point.what.value;
    std::string name = option_text(*find_option("renderer"), value);
    if (value.precision == Precision::float64) name += ", double";
    if (!point.placed() || std::find(named.begin(), named.end(), name) != named.end()) continue;
    svg += sign(value.renderer, {x + 6, y}, 6, fmt::format("fill=\"{}\"", hex_colour(mark_colour(value))), name);
    x += 19;
    words(name);
    named.push_back(std::move(name));
  }
  svg += line({x, y}, {x + 26, y}, "#000000", 2, " stroke-dasharray=\"7 5\"");
  x += 34;
  words("Pareto front");
  svg += fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"22\" height=\"12\" {}/>\n", x, y - 6, band_look);
  x += 28;
  words("within noise");
  if (std::any_of(chart.points.begin(), chart.points.end(),
                  [&](const ChartPoint& point) { return cost_with_upload(chart, point).has_value(); })) {
    svg += line({x, y}, {x + 22, y}, "#606060", 2, " stroke-dasharray=\"2 4\"");
    svg += line({x + 22, y - 7}, {x + 22, y + 7}, "#606060", 2);
    x += 30;
    words("with upload");
  }
  words(fmt::format("area: memory, up to {:.3g} MB", largest_memory));
  return svg;
}

/// The text in lines that fit on the paper, broken at blanks.
std::string notes(const std::string& text, double y, int size = note_size) {
  std::string svg, so_far;
  const auto put = [&] {
    svg += text_at(plot_corner.x, y, "start", so_far, size);
    y += size + 5;
    so_far.clear();
  };
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t blank = std::min(text.find(' ', from), text.size());
    const std::string word = text.substr(from, blank - from);
    if (!so_far.empty() && estimated_width(fmt::format("{} {}", so_far, word), size) > plot_size.x) put();
    so_far += (so_far.empty() ? "" : " ") + word;
    from = blank + 1;
  }
  if (!so_far.empty()) put();
  return svg;
}

}  // namespace

std::string chart_svg(const Chart& chart) {
  const ChartAxes axes = chart_axes(chart);
  const ChartIdentity& id = chart.identity;
  std::string svg = fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 "
                                "{0} {1}\" font-family=\"Inter, Helvetica, Arial, sans-serif\" fill=\"#202020\">\n"
                                "<rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n",
                                paper_width, paper_height);
  const std::string swept = chart_names(chart).common;
  svg += text_at(plot_corner.x, 36, "start",
                 fmt::format("{}, {} x {}: {} against error{}{}", id.scene, id.width, id.height,
                             chart_across_key(chart.across), swept.empty() ? "" : ", for each value of ", swept),
                 title_size, " font-weight=\"bold\"");
  double largest_memory = 0;
  for (const ChartPoint& point : chart.points) largest_memory = std::max(largest_memory, point.memory_mb);
  svg += legend(chart, largest_memory);
  svg += draw_axes(axes);
  svg += uncertain_band(chart, axes);
  svg += front_line(chart, axes);
  for (const ChartPoint& point : chart.points)
    if (point.placed()) svg += upload_bar(chart, point, axes) + mark(point, axes, largest_memory);
  svg += labels(chart, axes);
  const double below = plot_corner.y + plot_size.y;
  svg += notes(chart_conclusion(chart).sentence, below + 72, conclusion_size);
  const std::size_t missing = missing_points(chart).size();
  svg += notes(
      fmt::format("{}{} pixelscope {}, {}, {}, {} threads. {}", chart_provenance(chart),
                  missing == 0 ? "" : fmt::format(" Incomplete: {} of {} points are missing.", missing, id.points),
                  chart.machine.version, chart.machine.processor, chart.machine.simd, chart.machine.threads, id.base),
      below + 114);
  return svg_with_provenance(svg + "</svg>\n", provenance_of(chart.machine, id.base));
}

}  // namespace ps
