#include "study/model/simple_shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "math/unit.h"
#include "scene/object_boxes.h"
#include "scene/world.h"

namespace ps::model {
namespace {

constexpr double allowance = 1e-9;  ///< of lengths, in sizes of the model

struct WorldTriangle {
  std::array<Vec3d, 3> corners;
  Vec3d normal{0, 0, 0};  ///< towards its front, unit length
  double area = 0;
};

/// The triangles in the world; empty where one has no area, or a vertex normal that is not the triangle's own.
std::vector<WorldTriangle> flat_triangles(const Mesh& mesh, const Transform& transform) {
  std::vector<WorldTriangle> triangles;
  const Mat3d normals = normal_matrix(transform, NormalTransform::inverse_transpose);
  for (const MeshTriangle& triangle : mesh.triangles) {
    WorldTriangle one;
    for (std::size_t k = 0; k < 3; ++k) one.corners[k] = to_world(transform, mesh.positions[triangle.position[k]]);
    const Vec3d across = cross(one.corners[1] - one.corners[0], one.corners[2] - one.corners[0]);
    one.area = std::sqrt(dot(across, across)) / 2;
    if (!(one.area > 0)) return {};
    one.normal = across / (2 * one.area) * (mirrors(transform) ? -1.0 : 1.0);
    for (const std::int32_t index : triangle.normal)
      if (index >= 0 &&
          dot(normal_to_world(normals, mesh.normals[static_cast<std::size_t>(index)]), one.normal) < 1 - allowance)
        return {};
    triangles.push_back(one);
  }
  return triangles;
}

/// Three directions at right angles, the last of them a triangle's normal and the first along one of its edges that
/// meets another edge at a right angle.
std::optional<Mat3d> right_angled_frame(const WorldTriangle& triangle) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3d a = unit_or_zero(triangle.corners[(k + 1) % 3] - triangle.corners[k]);
    const Vec3d b = unit_or_zero(triangle.corners[(k + 2) % 3] - triangle.corners[k]);
    if (std::abs(dot(a, b)) < allowance) return Mat3d(a, cross(triangle.normal, a), triangle.normal);
  }
  return {};
}

/// The box around the model along the axes of a frame.
FormBox box_along(const std::vector<WorldTriangle>& triangles, const Mat3d& frame) {
  FormBox box;
  for (const WorldTriangle& triangle : triangles)
    for (const Vec3d& corner : triangle.corners) include_point(box, corner * frame);
  return box;
}

/// The area of the triangles on each of the six faces of the box; nullopt if one lies elsewhere or looks inwards.
std::optional<std::array<double, 6>> covered_faces(const std::vector<WorldTriangle>& triangles, const Mat3d& frame,
                                                   const FormBox& box, double length) {
  std::array<double, 6> covered{};
  for (const WorldTriangle& triangle : triangles) {
    const Vec3d normal = triangle.normal * frame;
    int axis = 0;
    while (axis < 3 && std::abs(normal[axis]) < 1 - allowance) ++axis;
    if (axis == 3) return {};
    const bool upper = normal[axis] > 0;
    const double face = upper ? box.high[axis] : box.low[axis];
    for (const Vec3d& corner : triangle.corners)
      if (std::abs((corner * frame)[axis] - face) > allowance * length) return {};
    covered[2 * static_cast<std::size_t>(axis) + (upper ? 1 : 0)] += triangle.area;
  }
  return covered;
}

std::optional<Form> form_of(const std::vector<WorldTriangle>& triangles) {
  const std::optional<Mat3d> frame = right_angled_frame(triangles.front());
  if (!frame) return {};
  const FormBox box = box_along(triangles, *frame);
  const Vec3d size = box.high - box.low;
  const double length = std::max({size.x, size.y, size.z});
  const auto equal = [&](double a, double b) { return std::abs(a - b) <= 1e-6 * b; };  // areas, which are sums
  if (size.z <= allowance * length) {
    double area = 0;
    for (const WorldTriangle& triangle : triangles) {
      if (dot(triangle.normal, (*frame)[2]) < 1 - allowance) return {};
      area += triangle.area;
    }
    if (!equal(area, size.x * size.y)) return {};
    return Rectangle{*frame * box.low, (*frame)[0] * size.x, (*frame)[1] * size.y};
  }
  const auto covered = covered_faces(triangles, *frame, box, length);
  if (!covered) return {};
  for (int axis = 0; axis < 3; ++axis)
    for (std::size_t side = 0; side < 2; ++side)
      if (!equal((*covered)[static_cast<std::size_t>(2 * axis) + side], size[(axis + 1) % 3] * size[(axis + 2) % 3]))
        return {};
  return Brick{*frame * ((box.low + box.high) / 2.0), size, *frame};
}

}  // namespace

std::optional<Solid> simple_shape(const Scene& scene, const Object& object) {
  const auto* instance = std::get_if<Instance>(&object.shape);
  if (!instance || object.dynamic) return {};
  const Mesh& mesh = *scene.geometry->meshes[instance->mesh];
  if (!mesh.patches.empty() || mesh.triangles.size() < 2) return {};
  const std::uint32_t slot = mesh.triangles.front().material;
  if (!instance->material && !std::all_of(mesh.triangles.begin(), mesh.triangles.end(),
                                          [&](const MeshTriangle& triangle) { return triangle.material == slot; }))
    return {};
  Solid solid;
  solid.material = instance->material.value_or(mesh.materials[slot]);
  solid.sides = instance->sides;
  if (needs_uv((*scene.materials)[solid.material])) return {};
  const std::vector<WorldTriangle> triangles = flat_triangles(mesh, instance->transform);
  if (triangles.empty()) return {};
  const std::optional<Form> form = form_of(triangles);
  if (!form) return {};
  solid.form = *form;
  return solid;
}

}  // namespace ps::model
