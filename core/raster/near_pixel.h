#pragma once
#include <algorithm>
#include <array>

#include "raster/pass.h"

namespace ps::raster {

/// Whether a triangle's box on the canvas, grown by one pixel, holds the pixel (array position). What lies behind the
/// camera has no place on the canvas and is left out.
template <class Real>
bool near_pixel(const Pass<Real>& pass, const std::array<Vec3<Real>, 3>& corner, Vec2i pixel) {
  ClipPolygon<Real> polygon;
  for (const auto& c : corner) polygon.push({c, Vec3<Real>(0)});
  if (pass.perspective()) {
    const Real least = static_cast<Real>(pass.viewport.distance * 1e-3);
    const ClipPlane<Real> front{{0, 0, 1}, -least, RejectReason::behind_camera, "front"};
    if (clip_polygon(polygon, front) == ClipOutcome::outside) return false;
  }
  Vec2<Real> low = pass.projection.from_top_left(polygon.corners[0].position);
  Vec2<Real> high = low;
  for (int i = 1; i < polygon.size; ++i) {
    const Vec2<Real> p = pass.projection.from_top_left(polygon.corners[static_cast<std::size_t>(i)].position);
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  return low.x - 1 <= Real(pixel.x + 1) && high.x + 1 >= Real(pixel.x) && low.y - 1 <= Real(pixel.y + 1) &&
         high.y + 1 >= Real(pixel.y);
}

}  // namespace ps::raster
