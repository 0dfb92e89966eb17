#pragma once
#include "math/vec.h"

namespace ps {

/// A texel that a lookup read: its place in its mip level, the share it has of the result, and its colour, linear.
struct Texel {
  int x = 0, y = 0, level = 0;
  double weight = 0;
  Vec3d colour{0, 0, 0};
};

}  // namespace ps
