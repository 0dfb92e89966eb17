#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "math/portable.h"  // IWYU pragma: export
#include "math/power.h"     // IWYU pragma: export
#include "scene/camera.h"
#include "scene/canvas_item.h"
#include "scene/mesh.h"
#include "scene/object.h"

/// The mathematics that the book takes for granted. Sums run from left to right, as its programs' do.

namespace ps {

inline double length(const Vec3d& v) { return std::sqrt(dot(v, v)); }

/// A camera as a photographer describes it, without a roll: the target lies on its line of sight.
struct BookView {
  Vec3d position{0, 0, 0}, target{0, 0, 1};
  double degrees = 0;  ///< from the upper border of the picture to its lower one
};

BookView book_view(const Camera& camera);

/// A point (w = 1) through a matrix.
inline Vec3d transform(const Mat4d& m, const Vec3d& p) {
  const auto row = [&](int i) { return m[0][i] * p.x + m[1][i] * p.y + m[2][i] * p.z + m[3][i]; };
  return {row(0), row(1), row(2)};
}

/// A direction (w = 0) through a matrix.
inline Vec3d turn(const Mat4d& m, const Vec3d& v) {
  const auto row = [&](int i) { return m[0][i] * v.x + m[1][i] * v.y + m[2][i] * v.z; };
  return {row(0), row(1), row(2)};
}

inline Mat4d translation_matrix(const Vec3d& by) {
  Mat4d m(1.0);
  m[3] = {by.x, by.y, by.z, 1};
  return m;
}

inline Mat4d scale_matrix(const Vec3d& by) {
  Mat4d m(1.0);
  for (int i = 0; i < 3; ++i) m[i][i] = by[i];
  return m;
}

inline Mat4d rotation_matrix(const Mat3d& rotation) { return Mat4d(rotation); }

/// World directions into the camera's: the inverse of the camera's rotation, which is its transpose.
inline Mat4d camera_rotation_inverse(const Camera& camera) {
  Mat4d m(1.0);
  for (int i = 0; i < 3; ++i) m[i] = {camera.right[i], camera.up[i], camera.forward[i], 0};
  return m;
}

/// Where an instance's vertices are in the world: scaled, then rotated, then moved (CGFS ch. 10).
inline Mat4d model_to_world(const Transform& t) {
  return translation_matrix(t.translation) * (rotation_matrix(t.rotation) * scale_matrix(t.scale));
}

/// The world as the camera sees it: what moved and turned the camera is undone (CGFS ch. 10).
inline Mat4d world_to_camera(const Camera& camera) {
  return camera_rotation_inverse(camera) * translation_matrix(-camera.position);
}

/// The nearest whole numbers not below x and not above it.
inline int round_up(double x) { return static_cast<int>(std::ceil(x)); }
inline int round_down(double x) { return static_cast<int>(std::floor(x)); }

/// The values of d along whole steps of i from i0 to i1, by adding the slope again and again (CGFS ch. 6).
template <class Value>
std::vector<Value> interpolate(double i0, const Value& d0, double i1, const Value& d1) {
  if (i0 == i1) return {d0};
  std::vector<Value> values;
  if (i1 > i0) values.reserve(static_cast<std::size_t>(std::min(i1 - i0, 1e5)) + 1);
  const Value slope = (d1 - d0) / (i1 - i0);
  Value d = d0;
  for (double i = i0; i <= i1; ++i) {
    values.push_back(d);
    d += slope;
  }
  return values;
}

/// The new value of a canvas pixel where `colour` meets what is `below`, both from 0 to 255: paint covers, light adds,
/// and a filter transmits a share of what is below (CGFS ch. 1).
inline Vec3d blended(Blend blend, const Vec3d& below, const Vec3d& colour) {
  switch (blend) {
  case Blend::replace:
    return colour;
  case Blend::additive:
    return below + colour;
  case Blend::subtractive:
    return below * colour / 255.0;
  }
  return colour;
}

/// Along the edges of a triangle whose vertices are at whole heights y0 <= y1 <= y2: the long edge, and the two short
/// ones joined (CGFS ch. 7).
template <class Value>
struct TriangleEdges {
  std::vector<Value> long_edge, short_edges;
};
template <class Value>
TriangleEdges<Value> interpolate_edges(const std::array<double, 3>& y, const std::array<Value, 3>& value) {
  TriangleEdges<Value> edges;
  edges.short_edges = interpolate(y[0], value[0], y[1], value[1]);
  edges.short_edges.pop_back();  // the second edge begins with it
  const std::vector<Value> second = interpolate(y[1], value[1], y[2], value[2]);
  edges.short_edges.insert(edges.short_edges.end(), second.begin(), second.end());
  edges.long_edge = interpolate(y[0], value[0], y[2], value[2]);
  return edges;
}

/// Indices of three vertices by height, from below. Equal heights keep their order.
inline std::array<std::size_t, 3> sorted_by_height(const std::array<Vec2d, 3>& p) {
  std::array<std::size_t, 3> order{0, 1, 2};
  const auto lower = [&](std::size_t a, std::size_t b) { return p[order[a]].y < p[order[b]].y; };
  if (lower(1, 0)) std::swap(order[1], order[0]);
  if (lower(2, 0)) std::swap(order[2], order[0]);
  if (lower(2, 1)) std::swap(order[2], order[1]);
  return order;
}

/// Throws std::out_of_range, which a student reads. Not where it is called, so that what calls it is short.
[[noreturn]] void throw_no_entry(std::size_t size);

/// The entry for `place`, counted from `first`; its fraction is dropped. Throws std::out_of_range where the list has no
/// such entry.
template <class Value>
const Value& entry(const std::vector<Value>& values, double place, double first) {
  const double from = place - first;
  if (!(from > -1 && from < static_cast<double>(values.size()))) throw_no_entry(values.size());
  return values[static_cast<std::size_t>(from)];
}

}  // namespace ps
