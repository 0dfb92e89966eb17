#include "image/height_map.h"

#include <algorithm>
#include <cmath>

namespace ps {

bool is_height_map(const Image<Vec3f>& image) {
  return std::all_of(image.pixels().begin(), image.pixels().end(),
                     [](const Vec3f& c) { return c.r == c.g && c.g == c.b; });
}

Image<Vec3f> normals_from_heights(const Image<Vec3f>& heights, double steepness) {
  const int width = heights.width(), height = heights.height();
  const auto at = [&](int x, int y) {
    return static_cast<double>(heights.at((x + width) % width, (y + height) % height).r) * steepness;
  };
  Image<Vec3f> normals(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const double right = (at(x + 1, y) - at(x - 1, y)) / 2, down = (at(x, y + 1) - at(x, y - 1)) / 2;
      const Vec3d normal = Vec3d{-right, down, 1} / std::sqrt(right * right + down * down + 1);  // y is upwards
      normals.at(x, y) = Vec3f(normal * 0.5 + Vec3d(0.5));
    }
  return normals;
}

}  // namespace ps
