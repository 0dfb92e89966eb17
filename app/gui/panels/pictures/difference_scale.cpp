#include "gui/panels/pictures/difference_scale.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "gui/widgets/draw.h"

namespace ps::gui {
namespace {

constexpr int scale_steps = 64;
constexpr double scale_width = 272, scale_height = 144, between = 8;  // at scale 1
constexpr double least_share = 0.6;  // of the picture's size without a scale, that one beside it may leave

double fitted_zoom(Vec2i size, const Area& area) {
  if (size.x <= 0 || size.y <= 0) return 0;
  return std::min(area.width() / static_cast<double>(size.x), area.height() / static_cast<double>(size.y));
}

std::string title_of(DifferenceMode mode) {
  switch (mode) {
  case DifferenceMode::absolute:
    return "|B - A| of each channel";
  case DifferenceMode::sign:
    return "B - A: blue A larger, orange B larger";
  case DifferenceMode::relative:
    return "|B - A| / (A + 1 % of white)";
  case DifferenceMode::flip:
    return "FLIP, 1 at most";
  }
  return {};
}

/// The lines below the scale.
std::vector<std::string> number_lines(const DifferenceNumbers& numbers, DifferenceMode mode) {
  if (numbers.at.x < 0) return {"no display level differs"};
  const auto text = [&](double value) { return difference_value_text(value, mode); };
  return {fmt::format("mean {}", text(numbers.mean)), fmt::format("99.9 % at most {}", text(numbers.percentile)),
          fmt::format("largest {} at ({}, {})", text(numbers.largest), numbers.at.x, numbers.at.y),
          fmt::format("{:.3g} % of the pixels differ", 100 * numbers.differing)};
}

}  // namespace

std::string difference_value_text(double value, DifferenceMode mode) {
  switch (mode) {
  case DifferenceMode::absolute:
  case DifferenceMode::sign:
    return fmt::format("{:.3g} level{}", value, value == 1 ? "" : "s");
  case DifferenceMode::relative:
    return fmt::format("{:.3g} %", 100 * value);
  case DifferenceMode::flip:
    return fmt::format("{:.3g}", value);
  }
  return {};
}

std::string difference_numbers_text(const DifferenceNumbers& numbers, DifferenceMode mode) {
  return fmt::format("{}", fmt::join(number_lines(numbers, mode), "; "));
}

DifferencePlaces difference_places(const Area& place, Vec2i picture_size) {
  const float width = px(scale_width), height = px(scale_height), space = px(between);
  const Area beside{place.min, {place.max.x - width - space, place.max.y}};
  const Area above{place.min, {place.max.x, place.max.y - height - space}};
  const double at_right = place.height() >= height ? fitted_zoom(picture_size, beside) : 0;
  const double at_bottom = place.width() >= width ? fitted_zoom(picture_size, above) : 0;
  if (std::max(at_right, at_bottom) < least_share * fitted_zoom(picture_size, place)) return {place, {}};
  if (at_right >= at_bottom) return {beside, Area{{beside.max.x + space, place.min.y}, place.max}};
  return {above, Area{{place.min.x, above.max.y + space}, place.max}};
}

void draw_difference_scale(ImDrawList& list, const DifferenceOptions& options, const DifferenceNumbers& numbers,
                           const Area& area) {
  const FontScope font(Face::small);
  const float line = px(19), margin = px(8), bar = px(14);
  const double end = full_scale(options.mode) / options.gain;
  const bool both_ways = options.mode == DifferenceMode::sign;
  const std::string low = both_ways ? "-" + difference_value_text(end, options.mode) : "0";
  const std::string high = (both_ways ? "+" : "") + difference_value_text(end, options.mode);
  const std::vector<std::string> lines = number_lines(numbers, options.mode);
  const float width = px(scale_width) - 2 * margin;
  const ImVec2 min = area.min, max{min.x + px(scale_width), min.y + px(scale_height)};
  controls().record("scale", min, max, low + " to " + high + "; " + difference_numbers_text(numbers, options.mode));

  list.AddRectFilled(min, max, colour_u32(palette().field), px(4));
  list.AddRect(min, max, colour_u32(palette().line_strong), px(4));
  ImVec2 at{min.x + margin, min.y + margin / 2};
  const auto write = [&](float x, const std::string& text) { draw_lines({x, at.y}, text, palette().text); };
  write(at.x, title_of(options.mode));
  at.y += line;
  for (int i = 0; i < scale_steps; ++i) {
    const double t = (i + 0.5) / scale_steps;
    const Rgb8 c = difference_colour(both_ways ? (2 * t - 1) * end : t * end, options);
    const float from = width * static_cast<float>(i) / scale_steps,
                to = width * static_cast<float>(i + 1) / scale_steps;
    list.AddRectFilled({at.x + from, at.y}, {at.x + to, at.y + bar}, IM_COL32(c.r, c.g, c.b, 255));
  }
  at.y += line;
  write(at.x, low);
  if (both_ways) write(at.x + (width - text_width("0")) / 2, "0");
  write(at.x + width - text_width(high), high);
  for (const std::string& text : lines) {
    at.y += line;
    write(at.x, text);
  }
}

}  // namespace ps::gui
