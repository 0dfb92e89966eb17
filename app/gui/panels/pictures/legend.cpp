#include <algorithm>
#include <cmath>

#include "gui/panels/pictures/legend_range.h"
#include "gui/panels/pictures/picture_view.h"
#include "gui/widgets/draw.h"
#include "image/heat_colour.h"

namespace ps::gui {
namespace {

constexpr int heat_steps = 48;
constexpr double most_counts = 4;  // as colours of their own; a longer range is a bar

ImU32 colour_of(Rgb8 c) { return IM_COL32(c.r, c.g, c.b, 255); }

/// Few whole numbers as a colour each, in place of a bar between them.
ChannelLegend counted(ChannelLegend legend) {
  const double length = legend.high - legend.low;
  if (!legend.heat || !legend.whole || length > most_counts || length != std::floor(length)) return legend;
  legend.heat = false;
  for (double count = legend.high; count >= legend.low; --count) {
    std::string meaning = short_number(count);
    if (count == legend.high && !legend.unit.empty()) meaning += " " + legend.unit;
    legend.entries.insert(legend.entries.begin(),
                          {heat_colour((count - legend.low) / std::max(length, 1.0)), std::move(meaning)});
  }
  return legend;
}

}  // namespace

std::optional<LegendScale> draw_legend(ImDrawList& list, const ChannelLegend& of, const Area& area) {
  const ChannelLegend legend = counted(of);
  const float frame = ImGui::GetFrameHeight();  // of the controls, which are in another face
  const FontScope font(Face::small);
  const float line = px(20), margin = px(8), swatch = px(14);
  const bool controls = legend.heat && area.width() >= px(range_width) + 4 * margin;
  const float heat_width = px(controls ? range_width : 180);
  std::string low = short_number(legend.low), high = short_number(legend.high);
  if (!legend.unit.empty()) high += " " + legend.unit;

  float width = text_width(legend.title);
  if (legend.heat) width = std::max({width, heat_width, text_width(low) + text_width(high) + margin});
  for (const auto& entry : legend.entries) width = std::max(width, swatch + margin + text_width(entry.meaning));
  const auto rows = static_cast<float>(1 + (legend.heat ? 2 : 0) + static_cast<int>(legend.entries.size()));
  const float numbers = controls ? frame + px(4) : line;       // height of their row
  const ImVec2 min{area.min.x + margin, area.min.y + margin};  // the lower edge has notices
  const ImVec2 max{area.min.x + margin * 3 + width, min.y + rows * line + margin + numbers - line};
  if (max.y > area.max.y) return {};

  const ImVec4& text = palette().text;
  list.AddRectFilled(min, max, colour_u32(palette().panel), px(4));
  list.AddRect(min, max, colour_u32(palette().line_strong), px(4));
  ImVec2 at{min.x + margin, min.y + margin / 2};
  draw_lines(at, legend.title, text);
  at.y += line;
  std::optional<LegendScale> scale;
  if (controls) {
    scale =
        LegendScale{{at, {at.x + width, at.y + swatch}}, {{at.x, at.y + line}, {at.x + width, at.y + line + frame}}};
    at.y += line + numbers;
  } else if (legend.heat) {
    for (int i = 0; i < heat_steps; ++i) {
      const auto step = static_cast<float>(i);
      list.AddRectFilled({at.x + width * step / heat_steps, at.y},
                         {at.x + width * (step + 1) / heat_steps, at.y + swatch},
                         colour_of(heat_colour((i + 0.5) / heat_steps)));
    }
    at.y += line;
    draw_lines(at, low, text);
    draw_lines({at.x + width - text_width(high), at.y}, high, text);
    at.y += line;
  }
  for (const auto& entry : legend.entries) {
    draw_swatch(list, at, {swatch, swatch}, colour_of(entry.colour));
    draw_lines({at.x + swatch + margin, at.y}, entry.meaning, text);
    at.y += line;
  }
  return scale;
}

}  // namespace ps::gui
