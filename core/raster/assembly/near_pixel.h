#pragma once
#include <algorithm>
#include <array>

#include "raster/base/raster_inputs.h"

namespace ps::raster {

/// What lies nearer than this to the eye's plane has no place on the canvas.
template <class Real>
Real least_depth(const RasterInputs<Real>& inputs) {
  return static_cast<Real>(inputs.viewport.distance * 1e-3);
}

/// Whether a triangle's box on the canvas, grown by one pixel, holds the pixel (array position). What lies behind the
/// camera has no place on the canvas and is left out.
template <class Real>
bool near_pixel(const RasterInputs<Real>& inputs, const std::array<Vec3<Real>, 3>& corner, Vec2i pixel) {
  ClipPolygon<Real> polygon;
  for (const auto& c : corner) polygon.push({c, Vec3<Real>(0)});
  if (inputs.perspective()) {
    const ClipPlane<Real> front{{0, 0, 1}, -least_depth(inputs), RejectReason::behind_camera, "front"};
    if (clip_polygon(polygon, front) == ClipOutcome::outside) return false;
  }
  Vec2<Real> low = inputs.projection.from_top_left(polygon.corners[0].position);
  Vec2<Real> high = low;
  for (int i = 1; i < polygon.size; ++i) {
    const Vec2<Real> p = inputs.projection.from_top_left(polygon.corners[static_cast<std::size_t>(i)].position);
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  return low.x - 1 <= Real(pixel.x + 1) && high.x + 1 >= Real(pixel.x) && low.y - 1 <= Real(pixel.y + 1) &&
         high.y + 1 >= Real(pixel.y);
}

/// Pixels between a triangle and an inspected pixel from which on it is far: near_pixel() and code that draws or
/// measures the pixel with its surroundings look less far.
inline constexpr int far_from_pixel = 3;

/// A quick answer for triangles whose vertices have a place: whether it is far from the pixel.
inline bool lies_far(const std::array<FixedPoint, 3>& corner, Vec2i pixel, int subpixel_bits) {
  const auto beyond = [&](int a, int b, int c, int at) {
    const std::int64_t unit = fixed_unit(subpixel_bits);
    return std::min({a, b, c}) > (at + 1 + far_from_pixel) * unit || std::max({a, b, c}) < (at - far_from_pixel) * unit;
  };
  return beyond(corner[0].x, corner[1].x, corner[2].x, pixel.x) ||
         beyond(corner[0].y, corner[1].y, corner[2].y, pixel.y);
}

}  // namespace ps::raster
