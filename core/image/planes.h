#pragma once
#include <algorithm>
#include <vector>

#include "image/image.h"

namespace ps {

/// One channel of a picture in double, for the metrics.
using ScalarImage = Image<double>;

/// Weights for the offsets -radius..radius; there are 2 * radius + 1.
using Kernel = std::vector<double>;

/// The correlation of a plane with the outer product of two kernels, along x and along y; beyond the border lie copies
/// of the border's pixels. One pass for each axis.
inline ScalarImage filtered(const ScalarImage& plane, const Kernel& along_x, const Kernel& along_y) {
  const int width = plane.width();
  const int height = plane.height();
  const int rx = static_cast<int>(along_x.size() / 2);
  const int ry = static_cast<int>(along_y.size() / 2);
  ScalarImage across(width, height);
  std::vector<double> padded(static_cast<std::size_t>(width + 2 * rx));
  for (int y = 0; y < height; ++y) {
    const auto from = plane.row(y);
    const auto to = across.row(y);
    std::fill(padded.begin(), padded.begin() + rx, from.front());
    std::copy(from.begin(), from.end(), padded.begin() + rx);
    std::fill(padded.end() - rx, padded.end(), from.back());
    for (std::size_t i = 0; i < along_x.size(); ++i)
      for (std::size_t x = 0; x < to.size(); ++x) to[x] += along_x[i] * padded[x + i];
  }
  ScalarImage result(width, height);
  for (int y = 0; y < height; ++y) {
    const auto to = result.row(y);
    for (int i = 0; i <= 2 * ry; ++i) {
      const auto from = across.row(std::clamp(y + i - ry, 0, height - 1));
      const double weight = along_y[static_cast<std::size_t>(i)];
      for (std::size_t x = 0; x < to.size(); ++x) to[x] += weight * from[x];
    }
  }
  return result;
}

}  // namespace ps
