#include "gui/panels/studies/chart_invitation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gui/widgets/draw.h"
#include "gui/widgets/shorten.h"
#include "options/difference_words.h"
#include "study/chart_style.h"

namespace ps::gui {
namespace {

constexpr double axes_margin = 24, inset = 24, mark_size = 6, least_height = 150;

/// Two axes with tips, and where good points will lie.
Area draw_axes(ImDrawList& list, const ChartTab& tab, const Area& area) {
  Chart chart;
  chart.metric = tab.metric;
  chart.across = tab.across;
  const ChartAxes axes = chart_axes(chart);
  const bool up = error_metric(chart.metric).higher_is_better;
  const FontScope small(Face::small);
  const float line = ImGui::GetTextLineHeight(), tip = px(5);
  const Area inner{{area.min.x + px(axes_margin), area.min.y + line + px(8)},
                   {area.max.x - px(axes_margin), area.max.y - line - px(8)}};
  const ImU32 ink = colour_u32(palette().text_quiet);
  list.AddRectFilled(inner.min, inner.max, colour_u32(palette().field));
  const ImVec2 origin{inner.min.x, inner.max.y}, right{inner.max.x, inner.max.y}, top{inner.min.x, inner.min.y};
  list.AddLine(origin, right, ink, px(1.5));
  list.AddLine(origin, top, ink, px(1.5));
  list.AddTriangleFilled({right.x - tip, right.y - tip}, {right.x + tip, right.y}, {right.x - tip, right.y + tip}, ink);
  list.AddTriangleFilled({top.x - tip, top.y + tip}, {top.x, top.y - tip}, {top.x + tip, top.y + tip}, ink);
  draw_text(area.min, {area.max.x, area.min.y + line}, axes.error_title + axes.error_sense, palette().text_quiet, 0);
  draw_text({inner.min.x, inner.max.y + px(6)}, area.max, axes.cost_title, palette().text_quiet, 0.5f);
  const float best = up ? inner.min.y + px(8) : inner.max.y - line - px(8);
  draw_text({inner.min.x + px(8), best}, {inner.max.x, best + line},
            whole_words(tab.across == ChartAcross::time   ? "the best corner: little error in little time"
                        : tab.across == ChartAcross::work ? "the best corner: little error with little work"
                                                          : "the best corner: little error in little memory",
                        inner.max.x - inner.min.x - px(8)),
            palette().text_quiet, 0);
  return inner;
}

std::string sentence(const ChartTab& tab, std::string_view button, bool measuring) {
  if (measuring) return "The first point appears when the reference is rendered.";
  if (tab.setup.swept == Swept::model)
    return fmt::format("{} weighs the model, as Needs does, and draws the way from the full to the reduced model, with "
                       "the pictures below.",
                       button);
  const std::size_t count = tab.plan.points.size();
  return fmt::format("{} renders {} picture{} and compares {} with the reference: {}.", button, count,
                     count == 1 ? "" : "s", count == 1 ? "it" : "each", settings_in_words(tab.plan.truth));
}

}  // namespace

void chart_invitation(const ChartTab& tab, const Area& area, std::string_view button, bool measuring) {
  auto& list = *ImGui::GetWindowDrawList();
  const std::string text = tab.plan.error.empty() ? sentence(tab, button, measuring) : tab.plan.error;
  controls().record("invitation", text);
  Area inner = area;
  if (area.height() >= px(least_height))
    inner = draw_axes(list, tab, area);
  else
    list.AddRectFilled(area.min, area.max, colour_u32(palette().field));
  list.PushClipRect(inner.min, inner.max, true);
  const float left = inner.min.x + px(inset), room = inner.width() - 2 * px(inset), line = ImGui::GetTextLineHeight();
  const std::string lines = in_lines(text, std::min(room, px(560)));
  ImVec2 at{left, inner.min.y + px(16)};
  draw_lines(at, lines, palette().text);
  at.y += text_height(lines) + px(16);

  std::vector<std::string> names;
  for (const SweepPoint& point : tab.plan.points) names.push_back(point.name);
  float column = 0;
  for (const std::string& name : names) column = std::max(column, text_width(name) + px(40));
  // As many columns as fit; the last place says how many are left out.
  const float bottom = inner.max.y - 2 * line - px(8);
  const auto rows = static_cast<std::size_t>(std::max(0.f, std::floor((bottom - at.y) / (line + px(4)))));
  const auto columns = static_cast<std::size_t>(std::max(1.f, std::floor(room / std::max(column, 1.f))));
  const std::size_t places = rows * columns, shown = names.size() <= places ? names.size()
                                                     : places > 0           ? places - 1
                                                                            : 0;
  for (std::size_t i = 0; i <= shown && i < names.size() && places > 0; ++i) {
    const std::size_t place_in_row = i / rows;
    const ImVec2 place{at.x + column * static_cast<float>(place_in_row),
                       at.y + (line + px(4)) * static_cast<float>(i % rows)};
    if (i == shown) {
      draw_lines({place.x + px(20), place.y}, fmt::format("and {} more", names.size() - shown), palette().text_quiet);
      break;
    }
    draw_planned_mark(list, tab.plan.points[i].value, {place.x + px(8), place.y + line / 2}, px(mark_size));
    draw_lines({place.x + px(20), place.y}, names[i], palette().text);
  }
  list.PopClipRect();
}

}  // namespace ps::gui
