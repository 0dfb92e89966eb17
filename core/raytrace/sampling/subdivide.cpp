#include "raytrace/sampling/subdivide.h"

#include "frame/display_frame.h"

namespace ps {

FirstRay first_ray(const Frame& frame, Vec2i pixel) {
  return {frame.ids.at(pixel.x, pixel.y), linear_at(frame, pixel)};
}

Image<std::uint8_t> pixels_to_subdivide(const Frame& frame, const TileRect& region, const SamplingPlan& plan) {
  Image<std::uint8_t> chosen(frame.width(), frame.height());
  // Each pair of neighbours is looked at once; the comparison does not depend on the order.
  const auto compare = [&](Vec2i a, Vec2i b) {
    if (!compare_rays(first_ray(frame, a), first_ray(frame, b), b, plan.threshold).subdivides) return;
    chosen.at(a.x, a.y) = 1;
    chosen.at(b.x, b.y) = 1;
  };
  const int x0 = std::max(region.x0 - 1, 0), x1 = std::min(region.x1 + 1, frame.width());
  const int y0 = std::max(region.y0 - 1, 0), y1 = std::min(region.y1 + 1, frame.height());
  for (int y = y0; y < y1; ++y)
    for (int x = x0; x < x1; ++x) {
      if (x + 1 < x1) compare({x, y}, {x + 1, y});
      if (y + 1 < y1) compare({x, y}, {x, y + 1});
    }
  return chosen;
}

}  // namespace ps
