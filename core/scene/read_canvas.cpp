#include <array>

#include <fmt/format.h>

#include "base/enumerators.h"
#include "scene/scene_draft.h"
#include "scene/scene_keys.h"

namespace ps {
namespace {

Blend read_blend(const SceneSource& source, const SceneFields& fields) {
  const SceneTerm* term = fields.find("blend");
  if (term == nullptr) return Blend::replace;
  constexpr const char* expected = "replace, additive or subtractive";
  if (const auto blend = enumerator_named<Blend>(source.values.name(*term, expected))) return *blend;
  source.values.fail(*term, expected);
}

/// The values of a list, one for each vertex.
const std::vector<SceneTerm>& each_vertex(const SceneSource& source, const SceneTerm& term, std::size_t vertices) {
  if (!term.is_list() || term.items.size() != vertices)
    source.values.fail(term, fmt::format("{} values, one for each vertex", vertices));
  return term.items;
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

void read_canvas_polygon(const SceneSource& source, const SceneEntry& entry, SceneDraft& draft) {
  const SceneValues& values = source.values;
  const SceneFields fields(values, entry, {"vertices", "color", "colors", "h", "filled", "outline", "blend"});
  const SceneTerm& vertices = fields.require("vertices");
  require_polygon_vertices(source, vertices);
  const std::size_t count = vertices.items.size();
  CanvasPolygon polygon;
  std::vector<Vec2d> points;
  for (const SceneTerm& term : vertices.items) points.push_back(values.vec2(term));
  if (!is_convex(points)) values.fail(vertices, "the vertices of a convex polygon, in order around it");
  for (const Vec2d& point : points) polygon.vertices.push_back({point});
  if (const auto* term = fields.find("color")) {
    fields.forbid({"colors"}, "only one of 'color' and 'colors'");
    for (CanvasVertex& vertex : polygon.vertices) vertex.colour = values.colour(*term);
  } else if (const auto* each = fields.find("colors")) {
    const auto& terms = each_vertex(source, *each, count);
    for (std::size_t i = 0; i < count; ++i) polygon.vertices[i].colour = values.colour(terms[i]);
  }
  if (const auto* each = fields.find("h")) {
    const auto& terms = each_vertex(source, *each, count);
    for (std::size_t i = 0; i < count; ++i) polygon.vertices[i].h = values.number(terms[i]);
  }
  if (const auto* term = fields.find("filled")) polygon.filled = values.on_off(*term);
  if (const auto* term = fields.find("outline")) polygon.outline = values.colour(*term);
  polygon.blend = read_blend(source, fields);
  draft.canvas_items.emplace_back(std::move(polygon));
}

}  // namespace ps
