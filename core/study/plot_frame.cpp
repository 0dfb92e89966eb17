#include "study/plot_frame.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ps {
namespace {

constexpr double between_labels = 8, least_inside = 20;  // pixels at scale 1, as below
constexpr double least_label_width = 30, right_margin = 10, below_titles = 5, beside_labels = 6, line_gap = 3;

std::string label_of(const Tick& tick) { return power_text(tick.value, tick.text); }

Stroke grid_line(const Tick& tick) { return {{Role::faint, tick.text.empty() ? 0.45 : 1}}; }

void draw_x_axis(Painter& painter, const PlotFrame& frame) {
  double taken = -INFINITY;
  for (const Tick& tick : frame.x.ticks()) {
    const double x = std::round(frame.at(tick.value, 0).x);
    painter.line({x, frame.inner.low.y}, {x, frame.inner.high.y}, grid_line(tick));
    if (tick.text.empty()) continue;
    const std::string text = label_of(tick);
    const double width = painter.extent(text, Lettering::label).width;
    if (x - width / 2 < taken + painter.px(between_labels)) continue;
    painter.text({x, frame.inner.high.y + painter.px(line_gap)}, text,
                 {.anchor = TextAnchor::middle, .level = TextLevel::top, .tint = {Role::quiet}});
    taken = x + width / 2;
  }
}

void draw_y_axis(Painter& painter, const PlotFrame& frame) {
  double taken = INFINITY;
  for (const Tick& tick : frame.y.ticks()) {
    const double y = std::round(frame.at(frame.x.low, tick.value).y);
    painter.line({frame.inner.low.x, y}, {frame.inner.high.x, y}, grid_line(tick));
    if (tick.text.empty()) continue;
    const std::string text = label_of(tick);
    const double half = painter.extent(text, Lettering::label).height() / 2;
    if (y + half > taken) continue;
    painter.text({frame.inner.low.x - painter.px(beside_labels), y}, text,
                 {.anchor = TextAnchor::end, .level = TextLevel::middle, .tint = {Role::quiet}});
    taken = y - half;
  }
}

/// Two strokes across an axis that leaps from zero to its smallest value. `along` is the axis' direction.
void draw_break(Painter& painter, const Vec2d& at, const Vec2d& along) {
  const Vec2d across(along.y, -along.x);
  painter.line(at - along * painter.px(1.5), at + along * painter.px(1.5), {{Role::paper}, 3});
  for (const double side : {-3.0, 3.0}) {
    const Vec2d middle = at + along * painter.px(side), tilt = across * painter.px(5) + along * painter.px(2.5);
    painter.line(middle - tilt, middle + tilt, {.width = 1.5});
  }
}

void draw_breaks(Painter& painter, const PlotFrame& frame) {
  const PaintArea& in = frame.inner;
  if (const auto place = frame.x.break_place())
    draw_break(painter, {in.low.x + in.width() * *place, in.high.y}, {1, 0});
  if (const auto place = frame.y.break_place())
    draw_break(painter, {in.low.x, in.high.y - in.height() * *place}, {0, 1});
}

}  // namespace

std::string power_text(double value, std::string plain) {
  static constexpr std::array digits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  if (plain.empty() || value <= 0) return plain;
  const double power = std::round(std::log10(value));
  if (std::abs(power) < 4 || std::abs(value / std::pow(10.0, power) - 1) > 1e-9) return plain;
  std::string text = power < 0 ? "10⁻" : "10";
  for (const char digit : std::to_string(static_cast<int>(std::abs(power))))
    text += digits[static_cast<std::size_t>(digit - '0')];
  return text;
}

Vec2d PlotFrame::at(double x_value, double y_value) const {
  return {inner.low.x + inner.width() * x.place(x_value), inner.high.y - inner.height() * y.place(y_value)};
}

PlotFrame draw_plot_frame(Painter& painter, const PaintArea& area, const PlotAxis& x, const PlotAxis& y,
                          const PlotTitles& titles) {
  const auto round = [](double a, double b) { return Vec2d(std::round(a), std::round(b)); };
  const TextLook quiet{.level = TextLevel::top, .tint = {Role::quiet}};
  const double height = painter.extent("0", Lettering::label).height(), line = height + painter.px(line_gap);
  const auto y_title = lines_of(painter, titles.y, Lettering::label, area.width());
  double label_width = painter.px(least_label_width);
  for (const Tick& tick : y.ticks())
    label_width = std::max(label_width, painter.extent(label_of(tick), Lettering::label).width);
  PlotFrame frame{{round(area.low.x + label_width + painter.px(right_margin),
                         area.low.y + static_cast<double>(y_title.size()) * height + painter.px(below_titles)),
                   round(area.high.x - painter.px(right_margin), area.high.y - 2 * line - painter.px(line_gap))},
                  x,
                  y};
  frame.inner.high = glm::max(frame.inner.high, frame.inner.low + painter.px(least_inside));
  painter.rectangle(frame.inner, {.fill = Tint{Role::paper}});
  draw_x_axis(painter, frame);
  draw_y_axis(painter, frame);
  painter.rectangle(frame.inner, {.stroke = Stroke{{Role::border}}});
  draw_breaks(painter, frame);
  for (std::size_t i = 0; i < y_title.size(); ++i)
    painter.text(area.low + Vec2d(0, static_cast<double>(i) * height), y_title[i], quiet);
  const double middle = (frame.inner.low.x + frame.inner.high.x - painter.extent(titles.x, Lettering::label).width) / 2;
  painter.text({std::max(area.low.x, middle), area.high.y - line}, titles.x, quiet);
  return frame;
}

}  // namespace ps
