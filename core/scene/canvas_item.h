#pragma once
#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "math/vec.h"

namespace ps {

/// How an item's colour meets what is on the canvas already (CGFS ch. 1): paint over it, add light, or take light away
/// as a filter or ink does (the product of both colours).
enum class Blend { replace, additive, subtractive };

/// A line on the canvas, in centred canvas coordinates with y up (CGFS ch. 6).
struct CanvasLine {
  std::array<Vec2d, 2> points{};
  Vec3d colour{0, 0, 0};
  Blend blend = Blend::replace;
  bool operator==(const CanvasLine&) const = default;
};

/// A triangle on the canvas (CGFS ch. 7). `h` is the book's intensity per vertex, multiplied into the colour.
struct CanvasTriangle {
  std::array<Vec2d, 3> points{};
  std::array<Vec3d, 3> colours{};
  std::array<double, 3> h{1, 1, 1};
  bool filled = true;
  Blend blend = Blend::replace;
  std::optional<Vec3d> outline;  ///< colour of an outline drawn over the fill
  bool operator==(const CanvasTriangle&) const = default;
};

/// A vertex of a polygon on the canvas; `h` as of a triangle.
struct CanvasVertex {
  Vec2d point{0, 0};
  Vec3d colour{0, 0, 0};
  double h = 1;
  bool operator==(const CanvasVertex&) const = default;
};

/// A convex polygon on the canvas (LAB 4): three vertices or more, in order around it, either way round.
struct CanvasPolygon {
  std::vector<CanvasVertex> vertices;
  bool filled = true;
  Blend blend = Blend::replace;
  std::optional<Vec3d> outline;  ///< colour of an outline drawn over the fill
  bool operator==(const CanvasPolygon&) const = default;
};

using CanvasItem = std::variant<CanvasLine, CanvasTriangle, CanvasPolygon>;

/// Whether the edges turn the same way at all vertices, and the polygon goes round once only. Vertices on the edge
/// between their neighbours are allowed; a polygon without area is not convex. Where twice the area of three vertices
/// is not above `straight`, they count as lying on a line.
bool is_convex(const std::vector<Vec2d>& points, double straight = 0);

/// The triangles around a polygon's first vertex that have an area, filled as it is, without its outline.
std::vector<CanvasTriangle> triangles_of(const CanvasPolygon& polygon);

/// The same drawing without polygons, for what knows lines and triangles alone: each polygon becomes its triangles, if
/// it is filled, and the lines of its outline.
std::vector<CanvasItem> lines_and_triangles(const std::vector<CanvasItem>& items);

}  // namespace ps
