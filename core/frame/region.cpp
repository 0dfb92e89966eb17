#include "frame/region.h"

#include <limits>

namespace ps {
namespace {

template <class Element>
void clear(const TileRect& region, Image<Element>& image, const Element& empty) {
  for (int y = 0; y < image.height(); ++y) {
    const bool inside = y >= region.y0 && y < region.y1;
    for (int x = 0; x < image.width(); ++x)
      if (!inside || x < region.x0 || x >= region.x1) image.at(x, y) = empty;
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
