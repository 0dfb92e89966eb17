#include "gui/panels/studies/bar_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "gui/base/record.h"
#include "gui/theme/theme.h"
#include "gui/widgets/draw.h"
#include "gui/widgets/shorten.h"
#include "gui/widgets/widgets.h"
#include "study/axis.h"

namespace ps::gui {
namespace {

constexpr double gap_between_rows = 9, title_gap = 6;       // pixels at scale 1
constexpr double most_name_width = 420, value_width = 110;  // pixels at scale 1
constexpr float most_name_share = 0.4f;                     // of the width
constexpr double many_times = 1000;                         // values that differ by more want a logarithmic scale

float bar_height() { return theme().font(Face::small)->FontSize + px(3); }

float row_height() { return 2 * bar_height() + px(gap_between_rows); }

struct Scale {
  PlotAxis axis;
  bool logarithmic = false;
  float share(double value) const {
    if (logarithmic) return static_cast<float>(axis.place(value));
    return static_cast<float>(std::clamp(std::abs(value) / axis.high, 0.0, 1.0));
  }
};

Scale scale_of(const ExperimentFigure& figure) {
  std::vector<double> sizes;
  double smallest = INFINITY, largest = 0;
  for (const ExperimentFigure::Row& row : figure.rows)
    for (const double value : {row.naive, row.robust}) {
      if (!std::isfinite(value)) continue;
      sizes.push_back(std::abs(value));
      largest = std::max(largest, std::abs(value));
      if (value != 0) smallest = std::min(smallest, std::abs(value));
    }
  Scale scale;
  scale.logarithmic = largest > many_times * smallest;
  if (scale.logarithmic) {
    sizes.push_back(0);  // a bar of 0 has no length, and the smallest a visible one
    scale.axis = fit_axis(sizes, AxisScale::logarithmic);
  } else {
    scale.axis.high = largest > 0 ? largest : 1;
  }
  return scale;
}

float name_width(const ExperimentFigure& figure, float width) {
  float widest = 0;
  for (const ExperimentFigure::Row& row : figure.rows) widest = std::max(widest, text_width(row.name));
  return std::min({widest + px(12), px(most_name_width), most_name_share * width});
}

}  // namespace

float bars_height(const ExperimentFigure& figure, const MethodNames& names, float width) {
  const float title = theme().font(Face::small)->FontSize + px(title_gap);
  return names.height(width) + title + static_cast<float>(figure.rows.size()) * row_height();
}

std::string draw_bars(ImDrawList& list, const Area& area, const ExperimentFigure& figure, const MethodNames& names,
                      ImVec2 mouse) {
  std::string cut = names.draw(list, area, mouse);
  const Scale scale = scale_of(figure);
  const FontScope small(Face::small);
  const float line = ImGui::GetFontSize();
  float y = area.min.y + names.height(area.width());
  const std::string title = figure.axis_title() + (scale.logarithmic ? "; the length of a bar is logarithmic" : "");
  draw_text({area.min.x, y}, {area.max.x, y + line}, whole_words(title, area.width()), palette().text_quiet, 0);
  controls().record("axis", title);
  y += line + px(title_gap);
  const float names_width = name_width(figure, area.width());
  const float from = area.min.x + names_width, room = std::max(area.max.x - from - px(value_width), px(20));
  for (std::size_t i = 0; i < figure.rows.size(); ++i, y += row_height()) {
    const ExperimentFigure::Row& row = figure.rows[i];
    const Area all{{area.min.x, y}, {area.max.x, y + 2 * bar_height()}};
    draw_text(all.min, {from - px(8), all.max.y}, row.name, palette().text, 1);
    if (text_width(row.name) > names_width - px(8) && all.contains(mouse)) cut = row.name;
    const double largest = std::max(std::abs(row.naive), std::abs(row.robust));
    std::string recorded;
    float top = y;
    for (const Method method : {Method::naive, Method::robust}) {
      const double value = method == Method::naive ? row.naive : row.robust;
      const float length = std::isnan(value) ? 0 : std::isinf(value) ? room : room * scale.share(value);
      list.AddRectFilled({from, top + px(1)}, {from + std::max(length, px(2)), top + bar_height() - px(1)},
                         colour_u32(method == Method::naive ? palette().wrong_mark : palette().right_mark,
                                    std::isnan(value) ? 0.25f : 1.0f));
      const std::string text = std::isnan(value) ? "none" : result_text(value, std::isnan(largest) ? value : largest);
      draw_text({from + length + px(8), top}, {area.max.x, top + bar_height()}, text,
                std::isnan(value) ? palette().text_quiet : palette().text, 0);
      recorded += (recorded.empty() ? "" : " ") + text;
      top += bar_height();
    }
    controls().record(fmt::format("bar/{}", i), all.min, all.max, fmt::format("{}: {}", row.name, recorded));
  }
  list.AddLine({from, area.min.y + names.height(area.width()) + line + px(title_gap)}, {from, y - px(gap_between_rows)},
               colour_u32(palette().line_strong));
  return cut;
}

}  // namespace ps::gui
