#include "gui/panels/studies/chart_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "gui/base/record.h"
#include "gui/panels/studies/plot_frame.h"
#include "gui/theme/theme.h"
#include "options/renderer_kind.h"
#include "study/chart_front.h"
#include "study/chart_style.h"

namespace ps::gui {
namespace {

constexpr float band_strength = 0.1f;
constexpr double reach = 8;  // pixels around a mark that still hit it, at scale 1

ImU32 colour_of(Rgb8 c) { return IM_COL32(c.r, c.g, c.b, 255); }

double largest_memory(const Chart& chart) {
  double largest = 0;
  for (const ChartPoint& point : chart.points) largest = std::max(largest, point.memory_mb);
  return largest;
}

struct Mark {
  std::size_t point = 0;
  ImVec2 at;
  float radius = 0;
};

std::vector<Mark> place_marks(const Chart& chart, const PlotFrame& frame) {
  const double memory = largest_memory(chart);
  std::vector<Mark> marks;
  for (std::size_t i = 0; i < chart.points.size(); ++i) {
    const ChartPoint& point = chart.points[i];
    if (!point.placed()) continue;
    marks.push_back({i, frame.at(point.cost.median, point.error), px(mark_radius(point.memory_mb, memory))});
  }
  return marks;
}

/// The front as steps, from the upper edge of the plot to its right one.
std::vector<ImVec2> front_steps(const Chart& chart, const PlotFrame& frame) {
  std::vector<ImVec2> steps;
  for (const Vec2d& corner : front_staircase(chart)) steps.push_back(frame.at(corner.x, corner.y));
  if (steps.empty()) return steps;
  const bool up = error_metric(chart.metric).higher_is_better;
  steps.insert(steps.begin(), {steps.front().x, up ? frame.inner.max.y : frame.inner.min.y});
  steps.push_back({frame.inner.max.x, steps.back().y});
  return steps;
}

void draw_front(ImDrawList& list, const Chart& chart, const PlotFrame& frame) {
  const std::vector<ImVec2> steps = front_steps(chart, frame);
  const float dash = px(5), gap = px(4);
  for (std::size_t i = 1; i < steps.size(); ++i) {
    const ImVec2 a = steps[i - 1], b = steps[i];
    const float length = std::hypot(b.x - a.x, b.y - a.y);
    for (float from = 0; from < length; from += dash + gap) {
      const float to = std::min(from + dash, length);
      const auto on_line = [&](float way) {
        return ImVec2{a.x + (b.x - a.x) * way / length, a.y + (b.y - a.y) * way / length};
      };
      list.AddLine(on_line(from), on_line(to), colour_u32(palette().text), px(1.2));
    }
  }
}

/// Where the front may lie, since times vary and the reference is uncertain.
void draw_uncertain_band(ImDrawList& list, const Chart& chart, const PlotFrame& frame) {
  for (const FrontBandPart& part : front_band(chart)) {
    const ImVec2 a = frame.at(part.cost_from, part.error.best), b = frame.at(part.cost_to, part.error.worst);
    list.AddRectFilled({a.x, std::min(a.y, b.y)}, {b.x, std::max(a.y, b.y)}, colour_u32(palette().text, band_strength));
  }
}

void draw_error_bar(ImDrawList& list, const ChartPoint& point, const PlotFrame& frame, ImU32 colour) {
  const ImVec2 low = frame.at(point.cost.q1, point.error), high = frame.at(point.cost.q3, point.error);
  const float cap = px(3);
  list.AddLine(low, high, colour, px(2));
  for (const ImVec2 end : {low, high}) list.AddLine({end.x, end.y - cap}, {end.x, end.y + cap}, colour, px(1.5));
}

/// A dotted line below the mark, from its middle to where that would lie with the upload of the scene.
void draw_upload_bar(ImDrawList& list, const Chart& chart, const ChartPoint& point, const PlotFrame& frame) {
  const auto whole = cost_with_upload(chart, point);
  if (!whole) return;
  const ImU32 colour = colour_of(mark_colour(point.what.value));
  ImVec2 from = frame.at(point.cost.median, point.error), to = frame.at(*whole, point.error);
  const float below = px(largest_mark_radius + 5);
  const float y = from.y + below < frame.inner.max.y ? from.y + below : from.y - below;
  from.y = to.y = y;
  const float dot = px(2), gap = px(3), cap = px(5);
  for (float x = from.x; x < to.x; x += dot + gap)
    list.AddLine({x, from.y}, {std::min(x + dot, to.x), from.y}, colour, px(2));
  list.AddLine({to.x, to.y - cap}, {to.x, to.y + cap}, colour, px(2));
}

void fill_mark(ImDrawList& list, Renderer renderer, ImVec2 at, float r, ImU32 fill) {
  switch (mark_shape(renderer)) {
  case MarkShape::circle:
    return list.AddCircleFilled(at, r, fill, 24);
  case MarkShape::square:
    return list.AddRectFilled({at.x - r, at.y - r}, {at.x + r, at.y + r}, fill);
  case MarkShape::diamond:
    return list.AddQuadFilled({at.x, at.y - r}, {at.x + r, at.y}, {at.x, at.y + r}, {at.x - r, at.y}, fill);
  case MarkShape::triangle:
    return list.AddTriangleFilled({at.x, at.y - r}, {at.x + r, at.y + r}, {at.x - r, at.y + r}, fill);
  }
}

void draw_mark(ImDrawList& list, const Mark& mark, const ChartPoint& point, bool strong) {
  const ImU32 own = colour_of(mark_colour(point.what.value));
  const bool hollow = point.tie || !point.ranked();
  const ImU32 fill = hollow ? colour_u32(palette().field) : own;
  const ImU32 edge = hollow && !strong ? own : colour_u32(point.on_front || strong ? palette().text : palette().field);
  const float r = mark.radius, width = px(strong ? 2.5 : 1.5);
  const ImVec2 low{mark.at.x - r, mark.at.y - r}, high{mark.at.x + r, mark.at.y + r};
  if (point.standing == Standing::truth) list.AddCircle(mark.at, r + px(truth_ring_gap), own, 28, px(1.5));
  fill_mark(list, point.what.value.renderer, mark.at, r, fill);
  switch (mark_shape(point.what.value.renderer)) {
  case MarkShape::circle:
    list.AddCircle(mark.at, r, edge, 24, width);
    break;
  case MarkShape::square:
    list.AddRect(low, high, edge, 0, 0, width);
    break;
  case MarkShape::diamond:
    list.AddQuad({mark.at.x, low.y}, {high.x, mark.at.y}, {mark.at.x, high.y}, {low.x, mark.at.y}, edge, width);
    break;
  case MarkShape::triangle:
    list.AddTriangle({mark.at.x, low.y}, high, {low.x, high.y}, edge, width);
    break;
  }
}

/// A ring with its letter around the point that a picture shows now.
void draw_ring(ImDrawList& list, const Mark& mark, const char* letter, const ImVec4& accent, float side) {
  ImFont* font = theme().font(Face::bold);
  list.AddCircle(mark.at, mark.radius + px(5), colour_u32(accent), 28, px(2));
  const ImVec2 size = font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, letter);
  const ImVec2 at{mark.at.x + side * (mark.radius + px(9) + size.x / 2) - size.x / 2, mark.at.y - size.y / 2};
  list.AddText(font, font->FontSize, at, colour_u32(palette().text), letter);
}

void draw_labels(ImDrawList& list, const Chart& chart, const PlotFrame& frame, const std::vector<Mark>& marks,
                 const ChartMarks& shown, ChartLabels& labels) {
  ImFont* font = theme().font(Face::small);
  const SweepNames names = chart_names(chart);
  const auto text_of = [&](const Mark& mark) {
    return mark_label(chart, chart.points[mark.point], names.parts[mark.point]);
  };
  const auto inside = [&](ImVec2 p) { return Vec2d(p.x - frame.inner.min.x, p.y - frame.inner.min.y); };
  std::string key = fmt::format("{} {} {}", frame.inner.width(), frame.inner.height(), static_cast<int>(chart.metric)) +
                    std::string(chart_across_key(chart.across));
  // The letter of a ring beside a mark takes room as an error bar does.
  const float letter = px(9) + theme().font(Face::bold)->FontSize;
  const auto taken = [&](const Mark& mark, const std::optional<std::size_t>& by) {
    return by && mark.point == *by ? mark.radius + letter : 0;
  };
  float radius = 0;
  for (const Mark& mark : marks) {
    const ChartPoint& point = chart.points[mark.point];
    key += fmt::format(" {:.0f},{:.0f},{:.0f},{:.0f},{:.0f},{:.0f}", mark.at.x, mark.at.y,
                       frame.at(point.cost.q1, point.error).x, frame.at(point.cost.q3, point.error).x,
                       taken(mark, shown.a), taken(mark, shown.b)) +
           (point.tie ? "t" : "");
    radius = std::max(radius, mark.radius);
  }
  if (key != labels.key || labels.places.size() != marks.size()) {
    labels.key = std::move(key);
    std::vector<LabelWish>& wishes = labels.wishes;
    wishes.clear();
    for (const Mark& mark : marks) {
      const ChartPoint& point = chart.points[mark.point];
      const ImVec2 size = font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, text_of(mark).c_str());
      const double farthest = std::max(point.cost.q3, cost_with_upload(chart, point).value_or(0));
      const float low = frame.at(point.cost.q1, point.error).x, high = frame.at(farthest, point.error).x;
      wishes.push_back(
          {inside(mark.at),
           {size.x, size.y},
           point.on_front ? 0 : 1,
           {std::max(mark.at.x - low, taken(mark, shown.a)), std::max(high - mark.at.x, taken(mark, shown.b))}});
    }
    std::vector<LabelLine> lines;
    const std::vector<ImVec2> steps = front_steps(chart, frame);
    for (std::size_t i = 1; i < steps.size(); ++i) lines.emplace_back(inside(steps[i - 1]), inside(steps[i]));
    labels.places = place_labels(wishes, {frame.inner.width(), frame.inner.height()}, radius, lines);
  }
  const auto outside = [&](const Vec2d& p) {
    return ImVec2{frame.inner.min.x + static_cast<float>(p.x), frame.inner.min.y + static_cast<float>(p.y)};
  };
  for (std::size_t i = 0; i < marks.size(); ++i) {
    if (!labels.places[i].shown) continue;
    if (const auto leader = label_leader(labels.wishes[i], labels.places[i], marks[i].radius))
      list.AddLine(outside(leader->first), outside(leader->second), colour_u32(palette().text_quiet), px(1));
    const ImVec2 at = outside(labels.places[i].corner);
    const ChartPoint& point = chart.points[marks[i].point];
    list.AddText(font, font->FontSize, {std::round(at.x), std::round(at.y)},
                 colour_u32(point.on_front ? palette().text : palette().text_quiet), text_of(marks[i]).c_str());
  }
}

std::optional<std::size_t> nearest(const std::vector<Mark>& marks, ImVec2 mouse) {
  std::optional<std::size_t> found;
  float best = 1e9f;
  for (const Mark& mark : marks) {
    const float distance = std::hypot(mark.at.x - mouse.x, mark.at.y - mouse.y);
    if (distance > mark.radius + px(reach) || distance >= best) continue;
    best = distance;
    found = mark.point;
  }
  return found;
}

}  // namespace

std::optional<std::size_t> draw_chart(ImDrawList& list, const Area& area, const Chart& chart, ChartLabels& labels,
                                      const ChartMarks& shown, ImVec2 mouse) {
  const ChartAxes axes = chart_axes(chart);
  const PlotFrame frame =
      draw_plot_frame(list, area, axes.cost, axes.error, {axes.cost_title, axes.error_title + axes.error_sense});
  list.PushClipRect(area.min, area.max, true);
  const std::vector<Mark> marks = place_marks(chart, frame);
  const auto hovered = nearest(marks, mouse);
  draw_uncertain_band(list, chart, frame);
  draw_front(list, chart, frame);
  for (const Mark& mark : marks) {
    const ChartPoint& point = chart.points[mark.point];
    draw_upload_bar(list, chart, point, frame);
    draw_error_bar(list, point, frame, colour_of(mark_colour(point.what.value)));
  }
  for (const Mark& mark : marks) {
    const ChartPoint& point = chart.points[mark.point];
    draw_mark(list, mark, point, mark.point == hovered);
    if (mark.point == shown.a) draw_ring(list, mark, "A", palette().a, -1);
    if (mark.point == shown.b) draw_ring(list, mark, "B", palette().b, 1);
    controls().record(fmt::format("point/{}", point.number), {mark.at.x - 2, mark.at.y - 2},
                      {mark.at.x + 2, mark.at.y + 2}, point.what.label);
  }
  draw_labels(list, chart, frame, marks, shown, labels);
  list.PopClipRect();
  return hovered;
}

void draw_planned_mark(ImDrawList& list, const Settings& settings, ImVec2 at, float radius) {
  fill_mark(list, settings.renderer, at, radius, colour_of(mark_colour(settings)));
}

float chart_legend_height() { return theme().font(Face::small)->FontSize + px(4); }

void draw_chart_legend(ImDrawList& list, const Area& area, const Chart& chart) {
  ImFont* font = theme().font(Face::small);
  const ImU32 ink = colour_u32(palette().text_quiet);
  const float middle = area.min.y + font->FontSize / 2;
  float x = area.min.x;
  const auto width_of = [&](const std::string& text) {
    return font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, text.c_str()).x;
  };
  std::set<Renderer> shown;
  for (const ChartPoint& point : chart.points) shown.insert(point.what.value.renderer);
  const auto entry = [&](const std::string& text, const auto& draw_sign) {
    const float sign = px(22), width = sign + width_of(text) + px(14);
    if (x + width > area.max.x) return;
    draw_sign(ImVec2{x + sign / 2 - px(2), middle});
    list.AddText(font, font->FontSize, {x + sign, area.min.y}, ink, text.c_str());
    x += width;
  };
  const float r = px(5);
  for (const Renderer renderer : shown)
    entry(std::string(renderer_label(renderer)), [&](ImVec2 at) {
      Settings settings;
      settings.renderer = renderer;
      fill_mark(list, renderer, at, r, colour_of(mark_colour(settings)));
    });
  entry("Pareto front", [&](ImVec2 at) {
    list.AddLine({at.x - px(8), at.y}, {at.x - px(2), at.y}, ink, px(1.2));
    list.AddLine({at.x + px(2), at.y}, {at.x + px(8), at.y}, ink, px(1.2));
  });
  entry("within noise", [&](ImVec2 at) {
    list.AddRectFilled({at.x - px(8), at.y - px(5)}, {at.x + px(8), at.y + px(5)},
                       colour_u32(palette().text, 2 * band_strength));
  });
  if (chart.across == ChartAcross::time)
    entry("quartiles", [&](ImVec2 at) {
      list.AddLine({at.x - px(7), at.y}, {at.x + px(7), at.y}, ink, px(2));
      for (const float end : {-px(7), px(7)}) list.AddLine({at.x + end, at.y - px(3)}, {at.x + end, at.y + px(3)}, ink);
    });
  if (std::any_of(chart.points.begin(), chart.points.end(),
                  [&](const ChartPoint& point) { return cost_with_upload(chart, point).has_value(); }))
    entry("with upload", [&](ImVec2 at) {
      for (const float dot : {-px(8), -px(4), 0.f, px(4)})
        list.AddLine({at.x + dot, at.y}, {at.x + dot + px(2), at.y}, ink, px(2));
      list.AddLine({at.x + px(7), at.y - px(4)}, {at.x + px(7), at.y + px(4)}, ink, px(1.5));
    });
  entry(fmt::format("area: memory, up to {:.3g} MB", largest_memory(chart)), [&](ImVec2 at) {
    list.AddCircle({at.x - px(4), at.y}, px(3), ink, 16);
    list.AddCircle({at.x + px(4), at.y}, px(5.5), ink, 20);
  });
}

}  // namespace ps::gui
