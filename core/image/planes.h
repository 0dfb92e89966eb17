#pragma once
#include <algorithm>
#include <functional>
#include <vector>

#include "image/image.h"

namespace ps {

/// One channel of a picture in double, for the metrics.
using Plane = Image<double>;

/// Weights for the offsets -radius..radius; there are 2 * radius + 1.
using Kernel = std::vector<double>;

/// The correlation of a plane with the outer product of two kernels, along x and along y; beyond the border lie copies
/// of the border's pixels. One pass for each axis.
inline Plane filtered(const Plane& plane, const Kernel& along_x, const Kernel& along_y) {
  const int width = plane.width();
  const int height = plane.height();
  const int rx = static_cast<int>(along_x.size() / 2);
  const int ry = static_cast<int>(along_y.size() / 2);
  Plane across(width, height);
  for (int y = 0; y < height; ++y) {
    const auto from = plane.row(y);
    const auto to = across.row(y);
    for (int x = 0; x < width; ++x) {
      double sum = 0;
      for (int i = -rx; i <= rx; ++i)
        sum +=
            along_x[static_cast<std::size_t>(i + rx)] * from[static_cast<std::size_t>(std::clamp(x + i, 0, width - 1))];
      to[static_cast<std::size_t>(x)] = sum;
    }
  }
  Plane result(width, height);
  for (int y = 0; y < height; ++y) {
    const auto to = result.row(y);
    for (int i = -ry; i <= ry; ++i) {
      const auto from = across.row(std::clamp(y + i, 0, height - 1));
      const double weight = along_y[static_cast<std::size_t>(i + ry)];
      for (std::size_t x = 0; x < to.size(); ++x) to[x] += weight * from[x];
    }
  }
  return result;
}

}  // namespace ps
