#pragma once
#include "raster/clear/coverage/inexact_edges.h"

namespace ps::raster {

/// Distance of a point from the line through a and b, times a factor that only depends on the line (CGPP 15.6.4.3). The
/// form n.p + d changes exactly its sign when a and b change places, so neighbours agree about their edge also in
/// float, though both may be wrong: far from the picture's corner d is large and loses digits.
template <class Real>
inline Real line_distance(const Vec2<Real>& a, const Vec2<Real>& b, const Vec2<Real>& p) {
  const Vec2<Real> normal(a.y - b.y, b.x - a.x);
  const Real offset = a.x * b.y - b.x * a.y;
  return (normal.x * p.x + normal.y * p.y) + offset;
}

/// The sample's weights: its distance from each edge as a fraction of the opposite vertex's.
template <class Real>
std::array<Real, 3> barycentric_weights(const CoverageInput& input, int column, int row) {
  const auto unit = static_cast<Real>(fixed_unit(input.grid.subpixel_bits));
  std::array<Vec2<Real>, 3> corner;
  for (std::size_t k = 0; k < 3; ++k)
    corner[k] = {static_cast<Real>(input.corners[k].x) / unit, static_cast<Real>(input.corners[k].y) / unit};
  const Vec2<Real> sample(static_cast<Real>(column) + static_cast<Real>(input.grid.sample.x),
                          static_cast<Real>(row) + static_cast<Real>(input.grid.sample.y));
  std::array<Real, 3> weights;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec2<Real>&a = corner[(i + 1) % 3], &b = corner[(i + 2) % 3];
    weights[i] = line_distance(a, b, sample) / line_distance(a, b, corner[i]);
  }
  return weights;
}

template <class Real>
bool weights_inside(const CoverageInput& input, const std::array<Real, 3>& weights) {
  const auto& threshold = input.edges.threshold;
  return inside_edge(weights[0], threshold[0]) && inside_edge(weights[1], threshold[1]) &&
         inside_edge(weights[2], threshold[2]);
}

/// Weights of every sample of the box, in Real: in double exact up to 9 sub-pixel bits, in float not.
template <class Real, class Sink>
void walk_barycentric(const CoverageInput& input, const TileRect& box, Sink& sink) {
  sink.test_all(box);
  for (int row = box.y0; row < box.y1; ++row)
    for (int column = box.x0; column < box.x1; ++column)
      if (weights_inside(input, barycentric_weights<Real>(input, column, row))) sink.cover(column, row);
}

}  // namespace ps::raster
