#pragma once
#include <cmath>

#include "math/vec.h"

namespace ps {

template <class Real>
inline bool has_nan(const Vec3<Real>& v) {
  return std::isnan(v.x) || std::isnan(v.y) || std::isnan(v.z);
}

template <class Real>
inline bool is_finite(const Vec3<Real>& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

}  // namespace ps
