#pragma once
#include <array>

#include "math/vec.h"

namespace ps {

enum class TriangleVerdict {
  inside,
  outside,   ///< the line passes by; `corner` names a vertex with a negative weight
  parallel,  ///< the line runs in the plane, or the determinant is too small
  guarded    ///< t is within its own rounding error of 0
};

/// Where a line meets a triangle. t and weights are given for `inside` and `outside`.
template <class Real>
struct TriangleResult {
  TriangleVerdict verdict = TriangleVerdict::outside;
  Real t = 0;
  std::array<Real, 3> weights{};
  int corner = -1;
};

}  // namespace ps
