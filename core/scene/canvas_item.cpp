#include "scene/canvas_item.h"

namespace ps {
namespace {

/// Twice the area of a triangle, above 0 where its vertices go round from +x to +y.
double vertex_turn(const Vec2d& a, const Vec2d& b, const Vec2d& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

void append(std::vector<CanvasItem>& items, const CanvasPolygon& polygon) {
  if (polygon.filled)
    for (CanvasTriangle& triangle : triangles_of(polygon)) items.emplace_back(triangle);
  if (!polygon.outline) return;
  const std::size_t count = polygon.vertices.size();
  for (std::size_t i = 0; i < count; ++i)
    items.emplace_back(CanvasLine{
        {polygon.vertices[i].point, polygon.vertices[(i + 1) % count].point}, *polygon.outline, Blend::replace});
}

}  // namespace

bool is_convex(const std::vector<Vec2d>& points, double straight) {
  bool left = false, right = false;
  const auto note = [&](double turned) {
    left = left || turned > straight;
    right = right || turned < -straight;
  };
  const std::size_t count = points.size();
  for (std::size_t i = 0; i < count; ++i) {
    note(vertex_turn(points[i], points[(i + 1) % count], points[(i + 2) % count]));
    if (i > 0 && i + 1 < count) note(vertex_turn(points[0], points[i], points[i + 1]));
  }
  return left != right;
}

std::vector<CanvasTriangle> triangles_of(const CanvasPolygon& polygon) {
  std::vector<CanvasTriangle> triangles;
  for (std::size_t i = 1; i + 1 < polygon.vertices.size(); ++i) {
    const std::array corners{polygon.vertices[0], polygon.vertices[i], polygon.vertices[i + 1]};
    if (vertex_turn(corners[0].point, corners[1].point, corners[2].point) == 0) continue;
    CanvasTriangle triangle;
    for (std::size_t k = 0; k < 3; ++k) {
      triangle.points[k] = corners[k].point;
      triangle.colours[k] = corners[k].colour;
      triangle.h[k] = corners[k].h;
    }
    triangle.filled = polygon.filled;
    triangle.blend = polygon.blend;
    triangles.push_back(triangle);
  }
  return triangles;
}

std::vector<CanvasItem> lines_and_triangles(const std::vector<CanvasItem>& items) {
  std::vector<CanvasItem> plain;
  for (const CanvasItem& item : items)
    if (const auto* polygon = std::get_if<CanvasPolygon>(&item))
      append(plain, *polygon);
    else
      plain.push_back(item);
  return plain;
}

}  // namespace ps
