#include "render/story/write_mixing.h"

#include <algorithm>
#include <cmath>

namespace ps {
namespace {

bool equal_but_for_rounding(const Vec3d& a, const Vec3d& b) {
  for (int i = 0; i < 3; ++i)
    if (std::abs(a[i] - b[i]) > 1e-6 * std::max(1.0, std::abs(a[i]))) return false;
  return true;
}

}  // namespace

Mixing mixing_of(const WriteEvent& write) {
  if (write.opacity < 1) return Mixing::blends;
  // On a dark pixel a sum of two passes is nearly the second one, too.
  if (write.after != write.shaded && equal_but_for_rounding(write.after, write.before + write.shaded))
    return Mixing::adds;
  return equal_but_for_rounding(write.after, write.shaded) ? Mixing::replaces : Mixing::filters;
}

}  // namespace ps
