#pragma once
#include <limits>

#include "math/vec.h"

namespace ps {

/// Finds the sample nearest to the centre of its pixel (ties: the first): it represents the pixel in channels that
/// cannot be averaged, such as ids.
class MiddleSample {
 public:
  bool is_nearer(const Vec2d& offset, const Vec2d& middle) {
    const Vec2d away = offset - middle;
    const double distance = dot(away, away);
    if (!(distance < nearest_)) return false;
    nearest_ = distance;
    return true;
  }

 private:
  double nearest_ = std::numeric_limits<double>::infinity();
};

}  // namespace ps
