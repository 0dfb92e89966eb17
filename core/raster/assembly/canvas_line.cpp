#include "raster/assembly/canvas_line.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "raster/base/clip.h"

namespace ps::raster {
namespace {

/// Half the width of what is walked at most, in pixels: twice the largest picture that fits into max_image_pixels as a
/// square.
constexpr double line_reach = 32768;

template <class Real>
bool cut(Vec2<Real>& a, Vec2<Real>& b) {
  if (!std::isfinite(a.x) || !std::isfinite(a.y) || !std::isfinite(b.x) || !std::isfinite(b.y)) return false;
  const auto limit = static_cast<Real>(line_reach);
  if (std::max({std::abs(a.x), std::abs(a.y), std::abs(b.x), std::abs(b.y)}) <= limit) return true;
  const std::vector<ClipPlane<Real>> borders{
      {{1, 0, 0}, limit, {}, {}}, {{-1, 0, 0}, limit, {}, {}}, {{0, 1, 0}, limit, {}, {}}, {{0, -1, 0}, limit, {}, {}}};
  Vec3<Real> from(a.x, a.y, 0);
  Vec3<Real> to(b.x, b.y, 0);
  if (!clip_segment(from, to, borders)) return false;
  a = {from.x, from.y};
  b = {to.x, to.y};
  return true;
}

}  // namespace

template <class Real>
bool make_canvas_line(Vec2<Real> a, Vec2<Real> b, int columns, int rows, ScreenLine<Real>& line) {
  if (!cut(a, b)) return false;
  const Vec2<Real> shift(static_cast<Real>(odd_shift(columns)), static_cast<Real>(odd_shift(rows)));
  line.from = a + shift;
  line.to = b + shift;
  // One pixel more on each side than the ends say: whatever the rounding, no pixel of the walk lies outside.
  const auto low = [](Real p, Real q) { return static_cast<int>(std::floor(std::min(p, q))) - 1; };
  const auto high = [](Real p, Real q) { return static_cast<int>(std::ceil(std::max(p, q))) + 1; };
  const Vec2i left_top = array_pixel({low(line.from.x, line.to.x), high(line.from.y, line.to.y)}, columns, rows);
  const Vec2i right_bottom = array_pixel({high(line.from.x, line.to.x), low(line.from.y, line.to.y)}, columns, rows);
  line.box = {std::max(left_top.x, 0), std::max(left_top.y, 0), std::min(right_bottom.x + 1, columns),
              std::min(right_bottom.y + 1, rows)};
  return true;
}

template bool make_canvas_line(Vec2<float>, Vec2<float>, int, int, ScreenLine<float>&);
template bool make_canvas_line(Vec2<double>, Vec2<double>, int, int, ScreenLine<double>&);

}  // namespace ps::raster
