#include <fmt/format.h>

#include <algorithm>

#include "options/renderer_kind.h"
#include "study/chart_drawing.h"
#include "study/chart_style.h"

namespace ps {
namespace {

constexpr double sign_width = 22, entry_gap = 14, line_gap_below = 4, sign_radius = 5;  // pixels at scale 1

/// Entries side by side, in lines while there is room.
class Legend {
 public:
  Legend(Painter& painter, const PaintArea& area) : painter_(painter), area_(area), at_(area.low) {}

  /// `draw_sign(middle)` draws what the text explains.
  template <class DrawSign>
  void entry(const std::string& text, const DrawSign& draw_sign) {
    const double sign = painter_.px(sign_width);
    const double width = sign + painter_.extent(text, Lettering::label).width;
    const double line = chart_legend_height(painter_);
    const bool next = at_.x + width > area_.high.x;
    if (next && at_.y + 2 * line > area_.high.y + 1) return;
    if (next) at_ = {area_.low.x, at_.y + line};
    draw_sign(Vec2d(at_.x + sign / 2 - painter_.px(2), at_.y + line / 2 - painter_.px(line_gap_below) / 2));
    painter_.text(at_ + Vec2d(sign, 0), text, {.level = TextLevel::top, .tint = {Role::quiet}});
    at_.x += width + painter_.px(entry_gap);
  }

 private:
  Painter& painter_;
  const PaintArea& area_;
  Vec2d at_;
};

}  // namespace

double chart_legend_height(const Painter& painter, int lines) {
  return lines * (painter.extent("0", Lettering::label).height() + painter.px(line_gap_below));
}

void draw_chart_legend(Painter& painter, const PaintArea& area, const Chart& chart) {
  Legend legend(painter, area);
  const Tint ink{Role::quiet};
  const auto across = [&](double length) { return Vec2d(painter.px(length), 0); };
  const auto down = [&](double length) { return Vec2d(0, painter.px(length)); };
  std::vector<std::string> named;
  for (const ChartPoint& point : chart.points) {
    const Settings& value = point.what.value;
    std::string name(renderer_label(value.renderer));
    if (value.precision == Precision::float64) name += ", double";
    if (!point.placed() || std::find(named.begin(), named.end(), name) != named.end()) continue;
    legend.entry(name, [&](const Vec2d& at) { fill_chart_mark(painter, value, at, painter.px(sign_radius)); });
    named.push_back(std::move(name));
  }
  legend.entry("Pareto front", [&](const Vec2d& at) { painter.line(at - across(10), at + across(10), chart_front); });
  legend.entry("within noise", [&](const Vec2d& at) {
    painter.rectangle({at - across(8) - down(5), at + across(8) + down(5)},
                      {.fill = Tint{chart_band.role, 2 * chart_band.opacity}});
  });
  if (chart.across == ChartAcross::time)
    legend.entry("quartiles", [&](const Vec2d& at) {
      painter.line(at - across(7), at + across(7), {ink, 2});
      for (const Vec2d& end : {at - across(7), at + across(7)}) painter.line(end - down(3), end + down(3), {ink});
    });
  if (std::any_of(chart.points.begin(), chart.points.end(),
                  [&](const ChartPoint& point) { return cost_with_upload(chart, point).has_value(); }))
    legend.entry("with upload", [&](const Vec2d& at) {
      painter.line(at - across(9), at + across(7), {ink, 2, dotted});
      painter.line(at + across(7) - down(4), at + across(7) + down(4), {ink, 1.5});
    });
  legend.entry(fmt::format("area: memory, up to {:.3g} MB", largest_memory(chart)), [&](const Vec2d& at) {
    painter.circle(at - across(4), painter.px(3), {.stroke = Stroke{ink}});
    painter.circle(at + across(4), painter.px(5.5), {.stroke = Stroke{ink}});
  });
}

}  // namespace ps
