#include "gui/panels/studies/chart_strip.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gui/widgets/draw.h"
#include "study/chart_front.h"
#include "study/chart_style.h"

namespace ps::gui {
namespace {

constexpr double strip_needs = 210, highest_strip = 150, part_of_height = 0.4;  // pixels at scale 1

/// "reduced objects, lights": the part that this name adds to the one before.
std::string newest_part(const std::string& name) {
  const auto comma = name.rfind(", ");
  return comma == std::string::npos ? name : "+ " + name.substr(comma + 2);
}

}  // namespace

float chart_strip_height(const Area& area) {
  if (area.height() < px(strip_needs)) return 0;
  return std::min(px(highest_strip), area.height() * static_cast<float>(part_of_height));
}

void draw_chart_strip(ChartTab& tab, const Area& area) {
  std::vector<const ChartPoint*> points;
  for (const ChartPoint& point : tab.chart.points)
    if (point.measured() && tab.found->pictures.contains(point.number)) points.push_back(&point);
  if (points.empty()) return;
  const SweepNames names = chart_names(tab.chart);
  auto& list = *ImGui::GetWindowDrawList();
  const FontScope small(Face::small);
  const float slot = area.width() / static_cast<float>(points.size()), line = ImGui::GetTextLineHeight();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const ChartPoint& point = *points[i];
    const auto& picture = tab.found->pictures.at(point.number);
    const Texture& texture = tab.strip.texture(std::to_string(point.number), picture);
    const float room = std::min(slot - px(6), px(260)), high = area.height() - 2 * line - px(8);
    const float scale =
        std::min(room / static_cast<float>(texture.width()), high / static_cast<float>(texture.height()));
    const ImVec2 size{std::round(scale * static_cast<float>(texture.width())),
                      std::round(scale * static_cast<float>(texture.height()))};
    const ImVec2 at{std::round(area.min.x + slot * static_cast<float>(i)), std::round(area.min.y + px(4))};
    list.AddImage(texture.id(), at, {at.x + size.x, at.y + size.y});
    const std::string name = newest_part(names.parts[static_cast<std::size_t>(&point - tab.chart.points.data())]);
    const ImVec2 text{at.x, at.y + size.y + px(2)}, end{at.x + slot - px(6), text.y + line};
    draw_text(text, end, name, palette().text, 0);
    const std::string error = point.standing == Standing::truth ? "the truth" : fmt::format("{:.2g}", point.error);
    draw_text({text.x, end.y}, {end.x, end.y + line}, error, palette().text_quiet, 0);
    controls().record(fmt::format("strip/{}", i), at, {at.x + size.x, at.y + size.y}, name);
  }
}

}  // namespace ps::gui
