#include "study/chart_drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/enumerators.h"
#include "study/chart_front.h"
#include "study/chart_style.h"
#include "study/counted_work.h"

namespace ps {
namespace {

constexpr double bar_cap = 4, bar_width = 2, upload_cap = 5, ring_gap = 5, letter_gap = 9;  // pixels at scale 1

Tint tint_of(const Settings& settings) { return {Role::own, 1, mark_colour(settings)}; }

/// Three or four corners, or none for a circle.
std::vector<Vec2d> mark_corners(MarkShape shape, const Vec2d& at, double r) {
  switch (shape) {
  case MarkShape::circle:
    return {};
  case MarkShape::square:
    return {at + Vec2d(-r, -r), at + Vec2d(r, -r), at + Vec2d(r, r), at + Vec2d(-r, r)};
  case MarkShape::diamond:
    return {at + Vec2d(0, -r), at + Vec2d(r, 0), at + Vec2d(0, r), at + Vec2d(-r, 0)};
  case MarkShape::triangle:
    return {at + Vec2d(0, -r), at + Vec2d(r, r), at + Vec2d(-r, r)};
  }
  return {};
}

void draw_sign(Painter& painter, Renderer renderer, const Vec2d& at, double radius, const ShapeLook& look) {
  const std::vector<Vec2d> corners = mark_corners(mark_shape(renderer), at, radius);
  if (corners.empty())
    painter.circle(at, radius, look);
  else
    painter.polygon(corners, look);
}

/// The front as steps, from the upper edge of the plot to its right one.
std::vector<Vec2d> front_steps(const Chart& chart, const PlotFrame& frame) {
  std::vector<Vec2d> steps;
  for (const Vec2d& corner : front_staircase(chart)) steps.push_back(frame.at(corner.x, corner.y));
  if (steps.empty()) return steps;
  const bool up = error_metric(chart.metric).higher_is_better;
  steps.insert(steps.begin(), {steps.front().x, up ? frame.inner.high.y : frame.inner.low.y});
  steps.emplace_back(frame.inner.high.x, steps.back().y);
  return steps;
}

/// Where the front may lie, since times vary and the reference is uncertain.
void draw_uncertain_band(Painter& painter, const Chart& chart, const PlotFrame& frame) {
  for (const FrontBandPart& part : front_band(chart)) {
    const Vec2d a = frame.at(part.cost_from, part.error.best), b = frame.at(part.cost_to, part.error.worst);
    painter.rectangle({glm::min(a, b), glm::max(a, b)}, {.fill = chart_band});
  }
}

void draw_error_bar(Painter& painter, const ChartPoint& point, const PlotFrame& frame) {
  const Vec2d low = frame.at(point.cost.q1, point.error), high = frame.at(point.cost.q3, point.error);
  const Vec2d cap(0, painter.px(bar_cap));
  const Stroke stroke{tint_of(point.what.value), bar_width};
  painter.line(low, high, stroke);
  for (const Vec2d& end : {low, high}) painter.line(end - cap, end + cap, stroke);
}

/// A dotted line below the mark, from its middle to where that would lie with the upload of the scene.
void draw_upload_bar(Painter& painter, const Chart& chart, const ChartPoint& point, const PlotFrame& frame) {
  const auto whole = cost_with_upload(chart, point);
  if (!whole) return;
  const Tint tint = tint_of(point.what.value);
  Vec2d from = frame.at(point.cost.median, point.error), to = frame.at(*whole, point.error);
  const double below = painter.px(largest_mark_radius + 5);
  from.y = to.y = from.y + below < frame.inner.high.y ? from.y + below : from.y - below;
  const Vec2d cap(0, painter.px(upload_cap));
  painter.line(from, to, {tint, bar_width, dotted});
  painter.line(to - cap, to + cap, {tint, bar_width});
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

void draw_mark(Painter& painter, const ChartMark& mark, const ChartPoint& point, bool strong) {
  const Tint own = tint_of(point.what.value), ink{Role::ink}, paper{Role::paper};
  const bool hollow = point.tie || !point.ranked();
  const Tint edge = hollow && !strong ? own : point.on_front || strong ? ink : paper;
  if (point.standing == Standing::truth)
    painter.circle(mark.at, mark.radius + painter.px(truth_ring_gap), {.stroke = Stroke{own, 1.5}});
  draw_sign(painter, point.what.value.renderer, mark.at, mark.radius,
            {hollow ? paper : own, Stroke{edge, strong ? 2.5 : 1.5}});
}

/// A ring with its letter around the point that a picture shows now. `side` is -1 for a letter at the left, 1 for one
/// at the right.
void draw_ring(Painter& painter, const ChartMark& mark, std::string_view letter, Role role, double side) {
  painter.circle(mark.at, mark.radius + painter.px(ring_gap), {.stroke = Stroke{{role}, 2}});
  painter.text(mark.at + Vec2d(side * (mark.radius + painter.px(letter_gap)), 0), letter,
               {.lettering = Lettering::strong,
                .anchor = side < 0 ? TextAnchor::end : TextAnchor::start,
                .level = TextLevel::middle});
}

class LabelDrawing {
 public:
  LabelDrawing(Painter& painter, const Chart& chart, const PlotFrame& frame, std::span<const ChartMark> marks,
               const ChartMarks& shown)
      : painter_(painter), chart_(chart), frame_(frame), marks_(marks), shown_(shown), names_(chart_names(chart)) {}

  void draw(ChartLabels& labels) {
    std::string key = layout_key();
    if (key != labels.key || labels.places.size() != marks_.size()) {
      labels.key = std::move(key);
      find_places(labels);
    }
    const Vec2d corner = frame_.inner.low;
    for (std::size_t i = 0; i < marks_.size(); ++i) {
      if (!labels.places[i].shown) continue;
      if (const auto leader = label_leader(labels.wishes[i], labels.places[i], marks_[i].radius))
        painter_.line(corner + leader->first, corner + leader->second, {{Role::quiet}});
      painter_.text(corner + labels.places[i].corner, text_of(marks_[i]),
                    {.level = TextLevel::top,
                     .tint = {chart_.points[marks_[i].point].on_front ? Role::ink : Role::quiet},
                     .ground = TextGround::rim,
                     .ground_tint = {Role::paper}});
    }
  }

 private:
  std::string text_of(const ChartMark& mark) const {
    return mark_label(chart_, chart_.points[mark.point], names_.parts[mark.point]);
  }

  /// Room beside a mark, as for an error bar, where the letter of a ring is.
  double taken(const ChartMark& mark, const std::optional<std::size_t>& by) const {
    if (!by || mark.point != *by) return 0;
    return mark.radius + painter_.px(letter_gap) + painter_.extent("A", Lettering::strong).height();
  }

  std::string layout_key() const {
    std::string key = fmt::format("{} {} {} {}", frame_.inner.width(), frame_.inner.height(),
                                  static_cast<int>(chart_.metric), enumerator_key(chart_.across));
    for (const ChartMark& mark : marks_) {
      const ChartPoint& point = chart_.points[mark.point];
      key += fmt::format(" {:.0f},{:.0f},{:.0f},{:.0f},{:.0f},{:.0f}{}", mark.at.x, mark.at.y,
                         frame_.at(point.cost.q1, point.error).x, frame_.at(point.cost.q3, point.error).x,
                         taken(mark, shown_.a), taken(mark, shown_.b), point.tie ? "t" : "");
    }
    return key;
  }

  void find_places(ChartLabels& labels) const {
    const Vec2d corner = frame_.inner.low;
    double radius = 0;
    labels.wishes.clear();
    for (const ChartMark& mark : marks_) {
      const ChartPoint& point = chart_.points[mark.point];
      const TextExtent size = painter_.extent(text_of(mark), Lettering::label);
      const double farthest = std::max(point.cost.q3, cost_with_upload(chart_, point).value_or(0));
      const double low = frame_.at(point.cost.q1, point.error).x, high = frame_.at(farthest, point.error).x;
      labels.wishes.push_back(
          {mark.at - corner,
           {size.width, size.height()},
           point.on_front ? 0 : 1,
           {std::max(mark.at.x - low, taken(mark, shown_.a)), std::max(high - mark.at.x, taken(mark, shown_.b))}});
      radius = std::max(radius, mark.radius);
    }
    std::vector<LabelLine> lines;
    const std::vector<Vec2d> steps = front_steps(chart_, frame_);
    for (std::size_t i = 1; i < steps.size(); ++i) lines.emplace_back(steps[i - 1] - corner, steps[i] - corner);
    labels.places = place_labels(labels.wishes, frame_.inner.high - corner, radius, lines);
  }

  Painter& painter_;
  const Chart& chart_;
  const PlotFrame& frame_;
  std::span<const ChartMark> marks_;
  const ChartMarks& shown_;
  SweepNames names_;
};

}  // namespace

PlotFrame draw_chart_frame(Painter& painter, const PaintArea& area, const Chart& chart) {
  const ChartAxes axes = chart_axes(chart);
  const std::string whole = axes.cost_title + axes.cost_spread + "; left is cheaper";
  const bool fits = painter.extent(whole, Lettering::label).width <= area.width();
  return draw_plot_frame(painter, area, axes.cost, axes.error,
                         {fits ? whole : axes.cost_title, axes.error_title + axes.error_sense});
}

std::vector<ChartMark> place_marks(const Painter& painter, const Chart& chart, const PlotFrame& frame) {
  const double memory = largest_memory(chart);
  std::vector<ChartMark> marks;
  for (std::size_t i = 0; i < chart.points.size(); ++i) {
    const ChartPoint& point = chart.points[i];
    if (!point.placed()) continue;
    marks.push_back({i, frame.at(point.cost.median, point.error), painter.px(mark_radius(point.memory_mb, memory))});
  }
  return marks;
}

void draw_chart(Painter& painter, const Chart& chart, const PlotFrame& frame, std::span<const ChartMark> marks,
                const ChartMarks& shown, ChartLabels& labels) {
  draw_uncertain_band(painter, chart, frame);
  painter.polyline(front_steps(chart, frame), chart_front);
  for (const ChartMark& mark : marks) {
    draw_upload_bar(painter, chart, chart.points[mark.point], frame);
    draw_error_bar(painter, chart.points[mark.point], frame);
  }
  for (const ChartMark& mark : marks) {
    const ChartPoint& point = chart.points[mark.point];
    painter.begin_named([&point] {
      return fmt::format("{}: {:.4g} ms ({:.4g} to {:.4g}), work {}, {}, {:.4g} MB", point.what.settings,
                         point.time_ms.median, point.time_ms.q1, point.time_ms.q3, work_text(point.work),
                         error_text(point), point.memory_mb);
    });
    draw_mark(painter, mark, point, mark.point == shown.hovered);
    painter.end_named();
    if (mark.point == shown.a) draw_ring(painter, mark, "A", Role::a, -1);
    if (mark.point == shown.b) draw_ring(painter, mark, "B", Role::b, 1);
  }
  LabelDrawing(painter, chart, frame, marks, shown).draw(labels);
}

void fill_chart_mark(Painter& painter, const Settings& settings, const Vec2d& at, double radius) {
  draw_sign(painter, settings.renderer, at, radius, {.fill = tint_of(settings)});
}

}  // namespace ps
