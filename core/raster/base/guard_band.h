#pragma once
#include <array>
#include <cmath>

#include "raster/base/clip.h"
#include "raster/base/edge_function.h"

namespace ps::raster {

/// Cuts a polygon whose positions are (x, y, anything linear on the canvas), in pixels from the top left, to what fixed
/// point can hold (guard_band). Sets `split` if it had to cut; false if nothing is left.
template <class Real>
bool cut_to_guard_band(ClipPolygon<Real>& polygon, bool& split) {
  constexpr Real reach = static_cast<Real>(guard_band);
  bool fits = true;
  for (int i = 0; i < polygon.size; ++i) {
    const Vec3<Real>& p = polygon.corners[static_cast<std::size_t>(i)].position;
    fits = fits && std::abs(p.x) <= reach && std::abs(p.y) <= reach;
  }
  if (fits) return true;
  constexpr std::array<std::array<int, 2>, 4> sides{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
  for (const auto& side : sides) {
    const ClipPlane<Real> plane{{Real(side[0]), Real(side[1]), 0}, reach, RejectReason::clipped_side, "guard band"};
    const ClipOutcome outcome = clip_polygon(polygon, plane);
    if (outcome == ClipOutcome::outside) return false;
    split = split || outcome == ClipOutcome::split;
  }
  return true;
}

}  // namespace ps::raster
