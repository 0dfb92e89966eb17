#include "gui/panels/studies/plot_frame.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "gui/theme/theme.h"
#include "gui/widgets/shorten.h"
#include "gui/widgets/widgets.h"

namespace ps::gui {
namespace {

constexpr double between_labels = 8;  // pixels at scale 1

/// "10⁵" for a power of ten that would be long; other texts as they are.
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

std::string label_of(const Tick& tick) { return power_text(tick.value, tick.text); }

struct Pen {
  ImDrawList& list;
  ImFont* font;
  ImVec2 size_of(const std::string& text) const {
    return font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, text.c_str());
  }
  void write(ImVec2 at, const std::string& text) const {
    list.AddText(font, font->FontSize, {std::round(at.x), std::round(at.y)}, colour_u32(palette().text_quiet),
                 text.c_str());
  }
  ImU32 grid(const Tick& tick) const { return colour_u32(palette().line, tick.text.empty() ? 0.45 : 1); }
};

void draw_x_axis(const Pen& pen, const PlotFrame& frame) {
  float taken = -1e9f;
  for (const Tick& tick : frame.x.ticks()) {
    const float x = std::round(frame.at(tick.value, 0).x);
    pen.list.AddLine({x, frame.inner.min.y}, {x, frame.inner.max.y}, pen.grid(tick));
    if (tick.text.empty()) continue;
    const std::string text = label_of(tick);
    const float width = pen.size_of(text).x, left = x - width / 2;
    if (left < taken + px(between_labels)) continue;
    pen.write({left, frame.inner.max.y + px(3)}, text);
    taken = left + width;
  }
}

void draw_y_axis(const Pen& pen, const PlotFrame& frame) {
  float taken = 1e9f;
  for (const Tick& tick : frame.y.ticks()) {
    const float y = std::round(frame.at(frame.x.low, tick.value).y);
    pen.list.AddLine({frame.inner.min.x, y}, {frame.inner.max.x, y}, pen.grid(tick));
    if (tick.text.empty()) continue;
    const std::string text = label_of(tick);
    const ImVec2 size = pen.size_of(text);
    const float top = y - size.y / 2;
    if (top + size.y > taken) continue;
    pen.write({frame.inner.min.x - size.x - px(6), top}, text);
    taken = top;
  }
}

/// Two strokes across an axis that leaps from zero to its smallest value.
void draw_break(const Pen& pen, ImVec2 at, bool along_x) {
  const float r = px(5), apart = px(3);
  for (const float side : {-1.0f, 1.0f}) {
    const ImVec2 middle{at.x + (along_x ? side * apart : 0), at.y + (along_x ? 0 : side * apart)};
    const ImVec2 tilt = along_x ? ImVec2{px(2.5), r} : ImVec2{r, px(2.5)};
    pen.list.AddLine({middle.x - tilt.x, middle.y + tilt.y}, {middle.x + tilt.x, middle.y - tilt.y},
                     colour_u32(palette().text), px(1.5));
  }
  pen.list.AddLine({at.x - (along_x ? px(1.5) : 0), at.y - (along_x ? 0 : px(1.5))},
                   {at.x + (along_x ? px(1.5) : 0), at.y + (along_x ? 0 : px(1.5))}, colour_u32(palette().field),
                   px(3));
}

void draw_breaks(const Pen& pen, const PlotFrame& frame) {
  if (const auto place = frame.x.break_place())
    draw_break(pen, {frame.inner.min.x + frame.inner.width() * static_cast<float>(*place), frame.inner.max.y}, true);
  if (const auto place = frame.y.break_place())
    draw_break(pen, {frame.inner.min.x, frame.inner.max.y - frame.inner.height() * static_cast<float>(*place)}, false);
}

}  // namespace

std::string axis_number(double value) { return power_text(value, short_number(value)); }

ImVec2 PlotFrame::at(double x_value, double y_value) const {
  return {inner.min.x + inner.width() * static_cast<float>(x.place(x_value)),
          inner.max.y - inner.height() * static_cast<float>(y.place(y_value))};
}

PlotFrame draw_plot_frame(ImDrawList& list, const Area& area, const PlotAxis& x, const PlotAxis& y,
                          const PlotTitles& titles) {
  const Pen pen{list, theme().font(Face::small)};
  float label_width = px(30);
  for (const Tick& tick : y.ticks()) label_width = std::max(label_width, pen.size_of(label_of(tick)).x);
  const float line = pen.font->FontSize + px(3);
  PlotFrame frame{{{std::round(area.min.x + label_width + px(10)), std::round(area.min.y + line + px(2))},
                   {std::round(area.max.x - px(10)), std::round(area.max.y - 2 * line - px(3))}},
                  x,
                  y};
  frame.inner.max.x = std::max(frame.inner.max.x, frame.inner.min.x + px(20));
  frame.inner.max.y = std::max(frame.inner.max.y, frame.inner.min.y + px(20));
  list.AddRectFilled(frame.inner.min, frame.inner.max, colour_u32(palette().field));
  draw_x_axis(pen, frame);
  draw_y_axis(pen, frame);
  list.AddRect(frame.inner.min, frame.inner.max, colour_u32(palette().line_strong));
  draw_breaks(pen, frame);
  const FontScope small(Face::small);
  pen.write({area.min.x, area.min.y}, whole_words(titles.y, area.width()));
  const float middle = (frame.inner.min.x + frame.inner.max.x - pen.size_of(titles.x).x) / 2;
  pen.write({std::max(area.min.x, middle), area.max.y - line}, titles.x);
  return frame;
}

}  // namespace ps::gui
