#pragma once
#include "raster/clear/coverage/input.h"

namespace ps::raster {

/// Edge functions in arithmetic that fails, to show how. It only decides coverage; what a covered sample shows is
/// computed as ever.

/// Whether a value of that sign lies inside, ties given to the edge's owner.
template <class Number>
inline bool inside_edge(Number value, std::int64_t threshold) {
  return value > 0 || (value == 0 && threshold < 0);
}

/// The edges in pixels, as float. Each starts at the vertex that comes first in the triangle's own order, so two
/// triangles measure their shared edge from different ends and may round to different sides.
struct FloatEdges {
  struct Edge {
    Vec2f from{0, 0}, along{0, 0};
  };
  std::array<Edge, 3> edge;

  float at(std::size_t i, float x, float y) const {
    const Edge& e = edge[i];
    return e.along.x * (y - e.from.y) - e.along.y * (x - e.from.x);
  }
};

inline FloatEdges make_float_edges(const CoverageInput& input) {
  const bool turned = doubled_area(input.corners) < 0;
  const auto unit = static_cast<float>(fixed_unit(input.grid.subpixel_bits));
  const auto pixels = [&](const FixedPoint& p) {
    return Vec2f(static_cast<float>(p.x) / unit, static_cast<float>(p.y) / unit);
  };
  FloatEdges edges;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec2f a = pixels(input.corners[(i + (turned ? 2 : 1)) % 3]);
    const Vec2f b = pixels(input.corners[(i + (turned ? 1 : 2)) % 3]);
    edges.edge[i] = {a, b - a};
  }
  return edges;
}

inline float float_sample(int pixel, double offset) { return static_cast<float>(pixel) + static_cast<float>(offset); }

/// edge-arithmetic = float: every sample computed afresh.
template <class Sink>
void walk_float_edges(const CoverageInput& input, const TileRect& box, Sink& sink) {
  const FloatEdges edges = make_float_edges(input);
  const auto& threshold = input.edges.threshold;
  sink.test_all(box);
  for (int row = box.y0; row < box.y1; ++row)
    for (int column = box.x0; column < box.x1; ++column) {
      const float x = float_sample(column, input.grid.sample.x), y = float_sample(row, input.grid.sample.y);
      if (inside_edge(edges.at(0, x, y), threshold[0]) && inside_edge(edges.at(1, x, y), threshold[1]) &&
          inside_edge(edges.at(2, x, y), threshold[2]))
        sink.cover(column, row);
    }
}

/// edge-arithmetic = float-stepped: the values of the triangle's first sample, then one rounded addition for each step,
/// whose errors add up. Steps always start at the triangle's box, not at the tile's.
template <class Sink>
void walk_stepped_edges(const CoverageInput& input, const TileRect& box, Sink& sink) {
  const FloatEdges edges = make_float_edges(input);
  const auto& threshold = input.edges.threshold;
  const TileRect& whole = input.whole;
  sink.test_all(box);
  std::array<float, 3> row_values{};
  for (std::size_t i = 0; i < 3; ++i)
    row_values[i] =
        edges.at(i, float_sample(whole.x0, input.grid.sample.x), float_sample(whole.y0, input.grid.sample.y));
  for (int row = whole.y0; row < box.y1; ++row) {
    std::array<float, 3> values = row_values;
    for (int column = whole.x0; row >= box.y0 && column < box.x1; ++column) {
      if (column >= box.x0 && inside_edge(values[0], threshold[0]) && inside_edge(values[1], threshold[1]) &&
          inside_edge(values[2], threshold[2]))
        sink.cover(column, row);
      for (std::size_t i = 0; i < 3; ++i) values[i] -= edges.edge[i].along.y;
    }
    for (std::size_t i = 0; i < 3; ++i) row_values[i] += edges.edge[i].along.x;
  }
}

/// The value that is left of an edge's when it is computed in 32 bits: the low ones. Vertices and samples are multiples
/// of two units (except samples with 0 sub-pixel bits), so values are multiples of four, which 32-bit code would leave
/// out.
inline std::int32_t wrapped(std::int64_t value, int subpixel_bits) {
  const std::int64_t kept = subpixel_bits >= 1 ? value / 4 : value;
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(static_cast<std::uint64_t>(kept)));
}

/// edge-arithmetic = int32: exact until a product needs more than 31 bits, then anything.
template <class Sink>
void walk_wrapped_edges(const CoverageInput& input, const TileRect& box, Sink& sink) {
  const int bits = input.grid.subpixel_bits;
  const auto& threshold = input.edges.threshold;
  sink.test_all(box);
  for (int row = box.y0; row < box.y1; ++row)
    for (int column = box.x0; column < box.x1; ++column) {
      const auto values = input.edges.at(column, row);
      if (inside_edge(wrapped(values[0], bits), threshold[0]) && inside_edge(wrapped(values[1], bits), threshold[1]) &&
          inside_edge(wrapped(values[2], bits), threshold[2]))
        sink.cover(column, row, values);
    }
}

}  // namespace ps::raster
