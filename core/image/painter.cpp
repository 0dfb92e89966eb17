#include "image/painter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace ps {
namespace {

constexpr double arc_error = 0.1;  // pixels at scale 1 between an arc and its chords
constexpr int most_chords = 96;

}  // namespace

void Painter::line(const Vec2d& from, const Vec2d& to, const Stroke& stroke) {
  const std::array ends{from, to};
  polyline(ends, stroke);
}

void Painter::arc(const Vec2d& middle, double radius, double from, double to, const Stroke& stroke) {
  const double bend = std::clamp(1 - px(arc_error) / std::max(radius, px(arc_error)), -1.0, 1.0);
  const double step = std::max(2 * std::acos(bend), 2 * std::numbers::pi / most_chords);
  const auto chords =
      static_cast<std::size_t>(std::clamp(std::ceil(std::abs(to - from) / step), 1.0, 1.0 * most_chords));
  std::array<Vec2d, most_chords + 1> points;
  for (std::size_t i = 0; i <= chords; ++i) {
    const double angle = from + (to - from) * static_cast<double>(i) / static_cast<double>(chords);
    points[i] = middle + radius * Vec2d(std::cos(angle), std::sin(angle));
  }
  polyline(std::span(points).first(chords + 1), stroke);
}

void Painter::text(const Vec2d& at, std::string_view words, const TextLook& look) {
  const TextExtent size = extent(words, look.lettering);
  Vec2d baseline = at;
  if (look.level == TextLevel::middle) baseline.y += (size.above - size.below) / 2;
  if (look.level == TextLevel::top) baseline.y += size.above;
  if (look.ground == TextGround::plate) {
    const double share = look.anchor == TextAnchor::start ? 0 : look.anchor == TextAnchor::middle ? 0.5 : 1;
    const Vec2d corner(baseline.x - share * size.width, baseline.y - size.above), margin(px(4), px(1));
    rectangle({corner - margin, corner + Vec2d(size.width, size.height()) + margin}, {.fill = look.ground_tint}, px(4));
  }
  write(baseline, words, look);
}

std::vector<std::string> lines_of(const Painter& painter, std::string_view text, Lettering lettering, double width) {
  std::vector<std::string> lines;
  std::string line;
  while (!text.empty()) {
    const std::string_view word = text.substr(0, text.find(' '));
    text.remove_prefix(std::min(word.size() + 1, text.size()));
    std::string longer = line.empty() ? std::string(word) : line + " " + std::string(word);
    if (!line.empty() && painter.extent(longer, lettering).width > width) {
      lines.push_back(std::move(line));
      longer = word;
    }
    line = std::move(longer);
  }
  if (!line.empty()) lines.push_back(std::move(line));
  return lines;
}

}  // namespace ps
