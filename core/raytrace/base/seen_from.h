#pragma once
#include <algorithm>

#include "accel/box.h"
#include "math/unit.h"

namespace ps {

/// The point from which boxes are seen, and the largest coordinate of their contents as seen from there.
template <class Real>
struct SeenFrom {
  Vec3<Real> centre{0};
  Real reach = 0;
};

/// How the boxes in `all` are best seen. Boxes are grown by some rounding errors of the coordinates, so that none turns
/// away what a test accepts. The tests of triangles and spheres begin with differences between the primitive's numbers
/// and the ray's origin: it makes no difference to them where in the world both are. If the scene lies far from the
/// world's origin for its size, errors of the world's coordinates would be larger than its boxes, and reject nothing.
/// Then it is seen from its middle; nearer ones and all that hold a solid, whose tests may begin otherwise, are seen
/// from the world's origin. `world_reach`: the largest coordinate there.
template <class Real>
SeenFrom<Real> seen_from(const Box<Real>& all, Real world_reach, bool no_solids) {
  constexpr Real far = 16;
  const SeenFrom<Real> world{Vec3<Real>(0), world_reach};
  if (all.empty() || !no_solids) return world;
  const Vec3<Real> middle = (all.low + all.high) * Real(0.5);
  const Real reach = std::max(largest_component(all.low - middle), largest_component(all.high - middle));
  if (!(world_reach > far * reach)) return world;
  return {middle, reach};
}

}  // namespace ps
