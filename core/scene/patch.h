#pragma once
#include <array>

#include "math/vec.h"

namespace ps {

/// A bicubic Bezier patch: control point [4 * row + column]. u runs along the columns, v along the rows, both in
/// [0, 1]. The front is the side to which cross(d/du, d/dv) points.
struct BezierPatch {
  std::array<Vec3d, 16> control;
  bool operator==(const BezierPatch&) const = default;
};

}  // namespace ps
