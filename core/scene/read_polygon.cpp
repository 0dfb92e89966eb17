#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "math/unit.h"
#include "scene/canvas_item.h"
#include "scene/scene_draft.h"

namespace ps {
namespace {

/// How far a vertex may lie from the plane of its polygon, as a share of the polygon's size: what is left of decimal
/// numbers with seven digits.
constexpr double flat_enough = 1e-6;

/// The mean normal of a polygon, as long as twice its area (Newell's method), from places relative to its first vertex.
Vec3d mean_normal(const std::vector<Vec3d>& points) {
  Vec3d normal{0, 0, 0};
  for (std::size_t i = 0; i + 1 < points.size(); ++i) normal += cross(points[i] - points[0], points[i + 1] - points[0]);
  return normal;
}

/// The polygon as seen along its normal, without the coordinate that is longest in it.
std::vector<Vec2d> flattened(const std::vector<Vec3d>& points, const Vec3d& normal) {
  int left_out = 0;
  for (const int axis : {1, 2})
    if (std::abs(normal[axis]) > std::abs(normal[left_out])) left_out = axis;
  std::vector<Vec2d> flat;
  flat.reserve(points.size());
  for (const Vec3d& p : points) flat.emplace_back(p[(left_out + 1) % 3], p[(left_out + 2) % 3]);
  return flat;
}

/// Throws InputError at the vertex that is farthest from the plane, if that is too far.
void require_flat(const SceneValues& values, const SceneTerm& vertices, const std::vector<Vec3d>& points,
                  const Vec3d& normal) {
  Vec3d centre{0, 0, 0};
  for (const Vec3d& p : points) centre += p / static_cast<double>(points.size());
  double size = 0, farthest = 0;
  std::size_t worst = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    size = std::max(size, length_of(points[i] - centre));
    const double away = std::abs(dot(points[i] - centre, normal)) / length_of(normal);
    if (away > farthest) farthest = away, worst = i;
  }
  if (farthest > flat_enough * size)
    values.fail(vertices.items[worst],
                fmt::format("a vertex in the plane of the polygon, which is {:.4g} away", farthest));
}

void read_space_polygon(const SceneSource& source, const SceneEntry& entry, SceneDraft& draft) {
  const SceneValues& values = source.values;
  const SceneFields fields(values, entry,
                           joined_keys({"name", "dynamic", "vertices", "material", "sides"}, surface_keys()));
  const SceneTerm& vertices = fields.require("vertices");
  require_polygon_vertices(source, vertices);
  Mesh mesh;
  for (const SceneTerm& term : vertices.items) mesh.positions.push_back(values.vec3(term));
  const Vec3d normal = mean_normal(mesh.positions);
  const double area = length_of(normal);
  if (!(area > 0) || !std::isfinite(area)) values.fail(vertices, "the vertices of a polygon with an area");
  require_flat(values, vertices, mesh.positions, normal);
  if (!is_convex(flattened(mesh.positions, normal), flat_enough * area))
    values.fail(vertices, "the vertices of a convex polygon, in order around it");
  for (std::uint32_t i = 1; i + 1 < mesh.positions.size(); ++i) {
    MeshTriangle triangle;
    triangle.position = {0, i, i + 1};
    if (length_of(cross(mesh.positions[i] - mesh.positions[0], mesh.positions[i + 1] - mesh.positions[0])) > 0)
      mesh.triangles.push_back(triangle);
  }
  mesh.materials = {material_for(source, fields, {}, draft)};
  if (draft.materials[mesh.materials.front()].texture >= 0)
    values.fail_at(entry.line, entry.column, "a polygon with a texture", "a model, which has 'uvs' too");
  charge_triangles(source, entry, mesh.triangles.size(), draft);
  add_single_model(source, fields, "polygon", std::move(mesh), draft);
}

}  // namespace

void require_polygon_vertices(const SceneSource& source, const SceneTerm& vertices) {
  constexpr std::size_t most_vertices = 1000;
  if (!vertices.is_list() || vertices.items.size() < 3 || vertices.items.size() > most_vertices)
    source.values.fail(vertices, fmt::format("a list of 3 to {} vertices such as (10, 5)", most_vertices));
}

void read_any_polygon(const SceneSource& source, const SceneEntry& entry, SceneDraft& draft) {
  if (has_vertices_in_space(entry))
    read_space_polygon(source, entry, draft);
  else
    read_canvas_polygon(source, entry, draft);
}

}  // namespace ps
