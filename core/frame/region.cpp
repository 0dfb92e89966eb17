#include "frame/region.h"

#include <algorithm>
#include <limits>
#include <span>

namespace ps {
namespace {

template <class Element>
void clear(const TileRect& region, Image<Element>& image, const Element& empty) {
  if (image.empty()) return;
  const TileRect part = common_part(region, {0, 0, image.width(), image.height()});
  for (int y = 0; y < image.height(); ++y) {
    const std::span<Element> row = image.row(y);
    if (is_empty(part) || y < part.y0 || y >= part.y1) {
      std::fill(row.begin(), row.end(), empty);
      continue;
    }
    std::fill(row.begin(), row.begin() + part.x0, empty);
    std::fill(row.begin() + part.x1, row.end(), empty);
  }
}

}  // namespace

void clear_outside(const TileRect& region, Frame& frame) {
  clear(region, frame.colour, Vec3f(0));
  clear(region, frame.colour_double, Vec3d(0));
  clear(region, frame.depth, std::numeric_limits<float>::infinity());
  clear(region, frame.normal, Vec3f(0));
  clear(region, frame.barycentric, Vec3f(0));
  clear(region, frame.uv, Vec2f(0));
  clear(region, frame.ids, PixelId{});
  clear(region, frame.facing, 0.0f);
  clear(region, frame.overdraw, 0u);
  clear(region, frame.tests, 0u);
  clear(region, frame.mip, -1.0f);
  clear(region, frame.stencil, std::int32_t{0});
  clear(region, frame.shadow, 0u);
  clear(region, frame.samples, 0u);
  clear(region, frame.direction, Vec3f(0));
}

}  // namespace ps
