#pragma once
#include <cstdint>
#include <cstdlib>

#include "math/vec.h"

namespace ps::raster {

/// Bresenham's line between two pixels, with integers alone: `error` holds how far the pixel is off the line, scaled
/// by both side lengths, and decides when to step along each axis. Every visited pixel is within half a pixel of the
/// line, measured across its longer side. Calls visit(pixel, step) from the first to the second.
template <class Visit>
void walk_bresenham(Vec2i from, Vec2i to, Visit&& visit) {
  const std::int64_t width = std::abs(static_cast<std::int64_t>(to.x) - from.x);
  const std::int64_t height = std::abs(static_cast<std::int64_t>(to.y) - from.y);
  const Vec2i direction{from.x < to.x ? 1 : -1, from.y < to.y ? 1 : -1};
  std::int64_t error = width - height;
  Vec2i pixel = from;
  for (int step = 0;; ++step) {
    visit(pixel, step);
    if (pixel == to) return;
    const std::int64_t doubled = 2 * error;
    if (doubled > -height) {
      error -= height;
      pixel.x += direction.x;
    }
    if (doubled < width) {
      error += width;
      pixel.y += direction.y;
    }
  }
}

}  // namespace ps::raster
