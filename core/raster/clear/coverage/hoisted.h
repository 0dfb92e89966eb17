#pragma once
#include "raster/clear/coverage/barycentric.h"

namespace ps::raster {

/// Barycentric weights with all that does not change lifted out of the loops (CGPP ex. 15.3): the three divisions once
/// for a triangle, the row's part of each edge once for a row. Two operations for each weight are left for a sample;
/// the only division there is that of perspective, by the interpolated 1/z.
template <class Real>
class HoistedWeights {
 public:
  explicit HoistedWeights(const CoverageInput& input)
      : sample_x_(static_cast<Real>(input.grid.sample.x)), sample_y_(static_cast<Real>(input.grid.sample.y)) {
    const auto unit = static_cast<Real>(fixed_unit(input.grid.subpixel_bits));
    std::array<Vec2<Real>, 3> corner;
    for (std::size_t k = 0; k < 3; ++k)
      corner[k] = {static_cast<Real>(input.corners[k].x) / unit, static_cast<Real>(input.corners[k].y) / unit};
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec2<Real>&a = corner[(i + 1) % 3], &b = corner[(i + 2) % 3];
      normal_[i] = {a.y - b.y, b.x - a.x};
      offset_[i] = a.x * b.y - b.x * a.y;
      scale_[i] = 1 / line_distance(a, b, corner[i]);
    }
  }

  void begin_row(int row) {
    const Real y = static_cast<Real>(row) + sample_y_;
    for (std::size_t i = 0; i < 3; ++i) row_[i] = normal_[i].y * y + offset_[i];
  }

  std::array<Real, 3> at(int column) const {
    const Real x = static_cast<Real>(column) + sample_x_;
    std::array<Real, 3> weights;
    for (std::size_t i = 0; i < 3; ++i) weights[i] = (normal_[i].x * x + row_[i]) * scale_[i];
    return weights;
  }

 private:
  Real sample_x_, sample_y_;
  std::array<Vec2<Real>, 3> normal_;
  std::array<Real, 3> offset_, scale_, row_{};
};

/// Weights of one sample.
template <class Real>
std::array<Real, 3> hoisted_weights(const CoverageInput& input, int column, int row) {
  HoistedWeights<Real> weights(input);
  weights.begin_row(row);
  return weights.at(column);
}

/// As barycentric; the sums are in another order, so in float other samples may fall to the wrong side of an edge.
template <class Real, class Sink>
void walk_hoisted(const CoverageInput& input, const TileRect& box, Sink& sink) {
  sink.test_all(box);
  HoistedWeights<Real> weights(input);
  for (int row = box.y0; row < box.y1; ++row) {
    weights.begin_row(row);
    for (int column = box.x0; column < box.x1; ++column)
      if (weights_inside(input, weights.at(column))) sink.cover(column, row);
  }
}

}  // namespace ps::raster
