#include <array>

#include <fmt/format.h>

#include "scene/scene_draft.h"
#include "scene/scene_keys.h"

namespace ps {
namespace {

Blend read_blend(const SceneSource& source, const SceneFields& fields) {
  const SceneTerm* term = fields.find("blend");
  if (term == nullptr) return Blend::replace;
  constexpr const char* expected = "replace, additive or subtractive";
  if (const auto blend = blend_named(source.values.name(*term, expected))) return *blend;
  source.values.fail(*term, expected);
}

/// The values of a list, one for each vertex.
const std::vector<SceneTerm>& each_vertex(const SceneSource& source, const SceneTerm& term, std::size_t vertices) {
  if (!term.is_list() || term.items.size() != vertices)
    source.values.fail(term, fmt::format("{} values, one for each vertex", vertices));
  return term.items;
}

/// Twice the area of a triangle, above 0 where its vertices go round from +x to +y.
double vertex_turn(const Vec2d& a, const Vec2d& b, const Vec2d& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Whether the edges turn the same way at all vertices, and the polygon goes round once only: then the triangles around
/// its first vertex do so, too.
bool is_convex(const std::vector<Vec2d>& points) {
  bool left = false, right = false;
  const auto note = [&](double turned) {
    left = left || turned > 0;
    right = right || turned < 0;
  };
  const std::size_t count = points.size();
  for (std::size_t i = 0; i < count; ++i) {
    note(vertex_turn(points[i], points[(i + 1) % count], points[(i + 2) % count]));
    if (i > 0 && i + 1 < count) note(vertex_turn(points[0], points[i], points[i + 1]));
  }
  return left != right;
}

}  // namespace

void read_line(const SceneSource& source, const SceneEntry& entry, SceneDraft& draft) {
  const SceneFields fields(source.values, entry, {"from", "to", "color", "blend"});
  CanvasLine line;
  line.points = {source.values.vec2(fields.require("from")), source.values.vec2(fields.require("to"))};
  if (const auto* term = fields.find("color")) line.colour = source.values.colour(*term);
  line.blend = read_blend(source, fields);
  draft.canvas_items.emplace_back(line);
}

void read_canvas_triangle(const SceneSource& source, const SceneEntry& entry, SceneDraft& draft) {
  const SceneValues& values = source.values;
  const SceneFields fields(values, entry, {"vertices", "color", "colors", "h", "filled", "outline", "blend"});
  CanvasTriangle triangle;
  const auto& points = source.values.corners(fields.require("vertices"));
  for (std::size_t i = 0; i < 3; ++i) triangle.points[i] = values.vec2(points[i]);
  if (const auto* term = fields.find("color")) {
    fields.forbid({"colors"}, "only one of 'color' and 'colors'");
    triangle.colours.fill(values.colour(*term));
  } else if (const auto* each = fields.find("colors")) {
    const auto& terms = source.values.corners(*each);
    for (std::size_t i = 0; i < 3; ++i) triangle.colours[i] = values.colour(terms[i]);
  }
  if (const auto* term = fields.find("h")) {
    const auto& terms = source.values.corners(*term);
    for (std::size_t i = 0; i < 3; ++i) triangle.h[i] = values.number(terms[i]);
  }
  if (const auto* term = fields.find("filled")) triangle.filled = values.on_off(*term);
  if (const auto* term = fields.find("outline")) triangle.outline = values.colour(*term);
  triangle.blend = read_blend(source, fields);
  draft.canvas_items.emplace_back(triangle);
}

void read_polygon(const SceneSource& source, const SceneEntry& entry, SceneDraft& draft) {
  constexpr std::size_t most_vertices = 1000;
  const SceneValues& values = source.values;
  const SceneFields fields(values, entry, {"vertices", "color", "colors", "h", "filled", "outline", "blend"});
  const SceneTerm& vertices = fields.require("vertices");
  if (!vertices.is_list() || vertices.items.size() < 3 || vertices.items.size() > most_vertices)
    values.fail(vertices, fmt::format("a list of 3 to {} vertices such as (10, 5)", most_vertices));
  const std::size_t count = vertices.items.size();
  std::vector<Vec2d> points;
  for (const SceneTerm& term : vertices.items) points.push_back(values.vec2(term));
  if (!is_convex(points)) values.fail(vertices, "the vertices of a convex polygon, in order around it");
  std::vector<Vec3d> colours(count, Vec3d{0, 0, 0});
  std::vector<double> h(count, 1.0);
  if (const auto* term = fields.find("color")) {
    fields.forbid({"colors"}, "only one of 'color' and 'colors'");
    colours.assign(count, values.colour(*term));
  } else if (const auto* each = fields.find("colors")) {
    const auto& terms = each_vertex(source, *each, count);
    for (std::size_t i = 0; i < count; ++i) colours[i] = values.colour(terms[i]);
  }
  if (const auto* each = fields.find("h")) {
    const auto& terms = each_vertex(source, *each, count);
    for (std::size_t i = 0; i < count; ++i) h[i] = values.number(terms[i]);
  }
  const Blend blend = read_blend(source, fields);
  const SceneTerm* filled = fields.find("filled");
  if (filled == nullptr || values.on_off(*filled))
    for (std::size_t i = 1; i + 1 < count; ++i) {
      CanvasTriangle piece;
      const std::array<std::size_t, 3> corners{0, i, i + 1};
      for (std::size_t k = 0; k < 3; ++k) {
        piece.points[k] = points[corners[k]];
        piece.colours[k] = colours[corners[k]];
        piece.h[k] = h[corners[k]];
      }
      piece.blend = blend;
      if (vertex_turn(piece.points[0], piece.points[1], piece.points[2]) != 0) draft.canvas_items.emplace_back(piece);
    }
  const SceneTerm* outline = fields.find("outline");
  if (outline == nullptr) return;
  const Vec3d colour = values.colour(*outline);
  for (std::size_t i = 0; i < count; ++i)
    draft.canvas_items.emplace_back(CanvasLine{{points[i], points[(i + 1) % count]}, colour, Blend::replace});
}

}  // namespace ps
