#include "raster/clear/canvas_outline.h"

#include <algorithm>
#include <cmath>

#include "raster/assembly/canvas_line.h"
#include "raster/clear/lines/walk_line.h"

namespace ps::raster {
namespace {

struct Vertex {
  Vec2d point{0, 0};
  Vec3d colour{0, 0, 0};
};

/// Keeps the part where `inside` is not negative (Sutherland and Hodgman 1974).
template <class Inside>
std::vector<Vertex> cut(const std::vector<Vertex>& vertices, Inside&& inside) {
  std::vector<Vertex> kept;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Vertex &a = vertices[i], &b = vertices[(i + 1) % vertices.size()];
    const double in_a = inside(a.point), in_b = inside(b.point);
    if (in_a >= 0) kept.push_back(a);
    if ((in_a >= 0) == (in_b >= 0)) continue;
    // From the inner end, which is near: from one far away nothing would be left of the digits.
    const bool from_a = in_a >= 0;
    const Vertex &from = from_a ? a : b, &to = from_a ? b : a;
    const double t = (from_a ? in_a : in_b) / std::abs(in_a - in_b);
    kept.push_back({from.point + (to.point - from.point) * t, from.colour + (to.colour - from.colour) * t});
  }
  return kept;
}

CanvasOutline outline_of(std::vector<Vertex> vertices, const Vec2i& picture_size, SamplePosition position) {
  const bool far = std::any_of(vertices.begin(), vertices.end(), [](const Vertex& v) {
    return std::max(std::abs(v.point.x), std::abs(v.point.y)) > farthest_vertex;
  });
  if (far) {
    // Half of what a double can hold is left, so that differences of two coordinates stay finite.
    constexpr double largest = 1e300;
    for (Vertex& v : vertices)
      v.point = {std::clamp(v.point.x, -largest, largest), std::clamp(v.point.y, -largest, largest)};
    for (const int axis : {0, 1})
      for (const double side : {-1.0, 1.0})
        vertices = cut(vertices, [&](const Vec2d& p) { return farthest_vertex - side * p[axis]; });
  }
  CanvasOutline outline;
  for (const Vertex& v : vertices) {
    const Vec2d shifted = v.point + Vec2d(odd_shift(picture_size.x), odd_shift(picture_size.y));
    outline.pixels.push_back(array_pixel(book_pixel_at(shifted, position), picture_size.x, picture_size.y));
    outline.colours.push_back(v.colour);
  }
  return outline;
}

}  // namespace

CanvasOutline canvas_outline(const CanvasTriangle& triangle, const Vec2i& picture_size, SamplePosition position) {
  std::vector<Vertex> vertices;
  for (std::size_t i = 0; i < 3; ++i) vertices.push_back({triangle.points[i], triangle.colours[i] * triangle.h[i]});
  return outline_of(std::move(vertices), picture_size, position);
}

CanvasOutline canvas_outline(const CanvasPolygon& polygon, const Vec2i& picture_size, SamplePosition position) {
  std::vector<Vertex> vertices;
  for (const CanvasVertex& v : polygon.vertices) vertices.push_back({v.point, v.colour * v.h});
  return outline_of(std::move(vertices), picture_size, position);
}

}  // namespace ps::raster
