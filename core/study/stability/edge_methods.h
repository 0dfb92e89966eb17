#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "raster/base/edge_function.h"
#include "study/stability/support.h"

namespace ps::stability {

/// Ways to ask whether a triangle covers a sample, for triangles in pixels that share edges. Each vertex is a float as
/// the projection left it.
using Corners = std::array<Vec2f, 3>;

/// Does an edge from a to b own the samples on it? Rows grow downwards.
inline bool owned(const Vec2f& a, const Vec2f& b) { return b.y - a.y < 0 || (b.y == a.y && b.x > a.x); }
inline bool inside(float value, const Vec2f& a, const Vec2f& b) { return value > 0 || (value == 0 && owned(a, b)); }

/// Calls edge(a, b) for the three edges in the triangle's own order, turned so that inside is positive.
template <class Edge>
inline bool all_edges(Corners p, Edge&& edge) {
  const Vec2f u = p[1] - p[0], v = p[2] - p[0];
  if (u.x * v.y - u.y * v.x < 0) std::swap(p[1], p[2]);
  return edge(p[0], p[1]) && edge(p[1], p[2]) && edge(p[2], p[0]);
}

inline float relative_value(const Vec2f& a, const Vec2f& b, const Vec2f& s) {
  return (b.x - a.x) * (s.y - a.y) - (b.y - a.y) * (s.x - a.x);
}

inline bool covers_relative(const Corners& p, const Vec2f& s) {
  return all_edges(p, [&](const Vec2f& a, const Vec2f& b) { return inside(relative_value(a, b, s), a, b); });
}
/// The same without a rule for samples on the edge: all of them are inside, or none.
inline bool covers_inclusive(const Corners& p, const Vec2f& s) {
  return all_edges(p, [&](const Vec2f& a, const Vec2f& b) { return relative_value(a, b, s) >= 0; });
}
inline bool covers_exclusive(const Corners& p, const Vec2f& s) {
  return all_edges(p, [&](const Vec2f& a, const Vec2f& b) { return relative_value(a, b, s) > 0; });
}
/// Weights u and v of two vertices by Cramer's rule, the third one's from 1 - u - v; none may be negative.
inline bool covers_barycentric(const Corners& p, const Vec2f& s) {
  const Vec2f e1 = p[1] - p[0], e2 = p[2] - p[0], to = s - p[0];
  const float area = e1.x * e2.y - e1.y * e2.x;
  const float u = (to.x * e2.y - to.y * e2.x) / area, v = (e1.x * to.y - e1.y * to.x) / area;
  return u >= 0 && v >= 0 && 1 - u - v >= 0;
}
/// From the vertex farther to the left, whichever triangle asks: both compute the same number.
inline bool covers_canonical(const Corners& p, const Vec2f& s) {
  return all_edges(p, [&](const Vec2f& a, const Vec2f& b) {
    const bool turn = b.x < a.x || (b.x == a.x && b.y < a.y);
    return inside(turn ? -relative_value(b, a, s) : relative_value(a, b, s), a, b);
  });
}
/// A x + B y + C: the same numbers for both triangles, so consistent, but C is large far from the origin.
inline bool covers_absolute(const Corners& p, const Vec2f& s) {
  return all_edges(p, [&](const Vec2f& a, const Vec2f& b) {
    const float A = a.y - b.y, B = b.x - a.x, C = a.x * b.y - a.y * b.x;
    return inside(A * s.x + B * s.y + C, a, b);
  });
}
/// From the triangle's box to the sample by additions.
inline bool covers_stepped(const Corners& p, const Vec2f& s) {
  const float x0 = std::floor(std::min({p[0].x, p[1].x, p[2].x})) + 0.5f;
  const float y0 = std::floor(std::min({p[0].y, p[1].y, p[2].y})) + 0.5f;
  return all_edges(p, [&](const Vec2f& a, const Vec2f& b) {
    float value = relative_value(a, b, {x0, y0});
    const float dx = b.x - a.x, dy = b.y - a.y;
    for (float y = y0; y < s.y; y += 1) value += dx;
    for (float x = x0; x < s.x; x += 1) value -= dy;
    return inside(value, a, b);
  });
}
/// Vertices rounded to `bits` after the point, edge values in 64-bit integers.
template <int bits>
inline bool covers_fixed(const Corners& p, const Vec2f& s) {
  const raster::CoverageGrid grid{bits, FillRule::top_left, {0.5, 0.5}};
  const auto edges = raster::make_edges(
      {raster::to_fixed(p[0], bits), raster::to_fixed(p[1], bits), raster::to_fixed(p[2], bits)}, grid);
  return edges && edges->inside(edges->at(static_cast<int>(s.x), static_cast<int>(s.y)));
}

}  // namespace ps::stability
