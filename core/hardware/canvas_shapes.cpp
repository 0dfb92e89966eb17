#include "hardware/canvas_shapes.h"

#include <cmath>

namespace ps::hardware {
namespace {

class Maker {
 public:
  Maker(const PicturePlan& plan, int subpixel_bits) : plan_(plan), steps_(std::exp2(subpixel_bits)) {}

  void add(const CanvasLine& line) {
    begin(true, line.blend);
    add_line(line.points[0], line.points[1], line.colour);
  }
  void add(const CanvasTriangle& triangle) {
    if (triangle.filled) {
      begin(false, triangle.blend);
      add_filled(triangle);
    }
    if (!triangle.outline) return;
    begin(true, Blend::replace);
    for (std::size_t k = 0; k < 3; ++k) add_line(triangle.points[k], triangle.points[(k + 1) % 3], *triangle.outline);
  }
  void add(const CanvasPolygon& polygon) {
    if (polygon.filled) {
      begin(false, polygon.blend);
      for (const CanvasTriangle& piece : triangles_of(polygon)) add_filled(piece);
    }
    if (!polygon.outline) return;
    begin(true, Blend::replace);
    for (std::size_t i = 0; i < polygon.vertices.size(); ++i)
      add_line(polygon.vertices[i].point, polygon.vertices[(i + 1) % polygon.vertices.size()].point, *polygon.outline);
  }
  CanvasShapes take() { return std::move(shapes_); }

 private:
  void begin(bool lines, Blend blend) { shapes_.draws.push_back({lines, blend, shapes_.corners.size(), 0}); }
  void add_corner(const Vec2d& point, const Vec3d& colour) {
    const Vec2d centre = shifted_centre(plan_);
    Vec2d place(centre.x + point.x, centre.y - point.y);
    if (plan_.settings.vertex_snapping == VertexSnapping::cpu)
      place = {std::nearbyint(place.x * steps_) / steps_, std::nearbyint(place.y * steps_) / steps_};
    shapes_.corners.push_back({Vec2f(place), Vec3f(colour)});
    ++shapes_.draws.back().count;
  }
  void add_filled(const CanvasTriangle& triangle) {
    for (std::size_t k = 0; k < 3; ++k) add_corner(triangle.points[k], triangle.colours[k] * triangle.h[k]);
  }
  void add_line(const Vec2d& from, const Vec2d& to, const Vec3d& colour) {
    add_corner(from, colour);
    add_corner(to, colour);
  }

  const PicturePlan& plan_;
  double steps_;
  CanvasShapes shapes_;
};

}  // namespace

CanvasShapes canvas_shapes(const PicturePlan& plan, int subpixel_bits) {
  Maker maker(plan, subpixel_bits);
  for (const CanvasItem& item : *plan.scene->canvas_items)
    std::visit([&](const auto& shape) { maker.add(shape); }, item);
  return maker.take();
}

}  // namespace ps::hardware
