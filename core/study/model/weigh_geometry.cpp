#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "base/number_text.h"
#include "math/unit.h"
#include "scene/generate/bezier_patch.h"
#include "scene/object_boxes.h"
#include "scene/world.h"
#include "study/model/model_search.h"

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

/// The box or the rectangle whose surface the triangles of a model cover exactly once, or nullopt: the model has
/// another shape, several materials, a picture on its surface, or vertex normals that round it off. Lengths may differ
/// by a billionth of the model's size.
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

Marks marks_of(const Candidates& chosen, std::size_t count) {
  Marks marks(count, 0);
  for (const std::size_t index : chosen) marks[index] = 1;
  return marks;
}

std::size_t triangles_in(const Scene& scene) {
  std::size_t count = 0;
  for (const auto& mesh : scene.geometry->meshes) count += mesh->triangles.size();
  return count;
}

Scene with_shapes(const Scene& scene, const Candidates& objects, const std::vector<std::optional<Solid>>& shapes) {
  Scene simpler = scene;
  simpler.geometry.edit([&](Geometry& geometry) {
    for (const std::size_t object : objects) geometry.objects[object].shape = *shapes[object];
  });
  return without_objects(simpler, Marks(simpler.geometry->objects.size(), 0));
}

/// Marks for each mesh the triangles that no instance of it shows.
std::vector<Marks> unseen_triangles(const Scene& scene, const Touched& touched) {
  std::vector<Marks> unseen;
  for (const auto& mesh : scene.geometry->meshes) unseen.emplace_back(mesh->triangles.size(), 1);
  for (std::size_t i = 0; i < scene.geometry->objects.size(); ++i)
    if (const auto* instance = std::get_if<Instance>(&scene.geometry->objects[i].shape))
      for (std::size_t k = 0; k < touched.objects[i].triangles.size(); ++k)
        if (touched.objects[i].triangles[k]) unseen[instance->mesh][k] = 0;
  return unseen;
}

}  // namespace

void ModelSearch::weigh_objects() {
  Candidates unseen;
  for (std::size_t i = 0; i < scene().geometry->objects.size(); ++i)
    if (evidence_.touched.objects[i].pixels == 0) unseen.push_back(i);
  const std::size_t all = scene().geometry->objects.size();
  const Scene full = scene();
  const Candidates gone = hold_together(
      unseen, Worth::unseen, [&](const Candidates& some) { return without_objects(full, marks_of(some, all)); });
  if (gone.empty()) return;
  ModelSaving saving{.part = ModelPart::objects, .goes = part_of_all(gone.size(), all, "object", "objects")};
  for (const std::size_t object : gone) {
    const std::uint64_t bytes = model_bytes(full) - model_bytes(without_objects(full, marks_of({object}, all)));
    saving.things.push_back({.name = object_name(full, object), .picture = 0, .bytes = bytes});
  }
  take(std::move(saving));
  forget(full, gone);
}

void ModelSearch::forget(const Scene& before, const Candidates& gone) {
  const Marks marks = marks_of(gone, before.geometry->objects.size());
  std::vector<Touched::Object> left;
  for (std::size_t i = 0; i < marks.size(); ++i)
    if (!marks[i]) left.push_back(std::move(evidence_.touched.objects[i]));
  evidence_.touched.objects = std::move(left);
  // Textures that only they had are gone with them.
  std::vector<std::optional<float>> levels;
  for (std::size_t i = 0; i < before.textures->size(); ++i)
    if (std::any_of(scene().textures->begin(), scene().textures->end(),
                    [&](const Texture& texture) { return texture.texels == (*before.textures)[i].texels; }))
      levels.push_back(evidence_.finest_level[i]);
  levels.resize(scene().textures->size());
  evidence_.finest_level = std::move(levels);
}

void ModelSearch::weigh_shapes() {
  std::vector<std::optional<Solid>> shapes;
  Candidates simple;
  for (const Object& object : scene().geometry->objects) {
    shapes.push_back(simple_shape(scene(), object));
    if (shapes.back()) simple.push_back(shapes.size() - 1);
  }
  const Scene before = scene();
  const Candidates changed = hold_together(simple, Worth::unchanged,
                                           [&](const Candidates& some) { return with_shapes(before, some, shapes); });
  if (changed.empty()) return;
  ModelSaving saving{
      .part = ModelPart::shapes,
      .goes = fmt::format("the triangles of {}", part_of_all(changed.size(), shapes.size(), "object", "objects"))};
  bool boxes = false, rectangles = false;
  for (const std::size_t object : changed) {
    const auto& instance = std::get<Instance>(before.geometry->objects[object].shape);
    (std::holds_alternative<Brick>(shapes[object]->form) ? boxes : rectangles) = true;
    saving.things.push_back(
        {.name = fmt::format("{}: a {} does", object_name(before, object), form_name(shapes[object]->form)),
         .picture = static_cast<double>(evidence_.touched.objects[object].pixels) / evidence_.pixels,
         .bytes = mesh_bytes(*before.geometry->meshes[instance.mesh])});
    evidence_.touched.objects[object].triangles.clear();
  }
  const bool one = changed.size() == 1;
  saving.kept = one                   ? (boxes ? "a box does" : "a rectangle does")
                : boxes && rectangles ? "boxes and rectangles do"
                : boxes               ? "boxes do"
                                      : "rectangles do";
  take(std::move(saving));
}

void ModelSearch::weigh_triangles() {
  const std::vector<Marks> unseen = unseen_triangles(scene(), evidence_.touched);
  Candidates meshes;
  for (std::size_t i = 0; i < unseen.size(); ++i) {
    const auto gone = static_cast<double>(count_marks(unseen[i])), all = static_cast<double>(unseen[i].size());
    const bool enough = gone >= least_saving * all && gone < all;
    if (enough && scene().geometry->meshes[i]->patches.empty()) meshes.push_back(i);
  }
  const Scene before = scene();
  const Candidates changed = hold_together(meshes, Worth::unchanged, [&](const Candidates& some) {
    Scene less = before;
    for (const std::size_t mesh : some)
      less = with_mesh(less, mesh, without_triangles(*before.geometry->meshes[mesh], unseen[mesh]));
    return less;
  });
  if (changed.empty()) return;
  const std::size_t all = triangles_in(before), left = triangles_in(last_.scene);
  ModelSaving saving{.part = ModelPart::triangles,
                     .goes = fmt::format("{} of {} triangles", with_thousands(std::to_string(all - left)),
                                         with_thousands(std::to_string(all)))};
  for (const std::size_t mesh : changed) {
    const Mesh& whole = *before.geometry->meshes[mesh];
    saving.things.push_back({.name = fmt::format("model '{}': {} of {} triangles", whole.name,
                                                 with_thousands(std::to_string(count_marks(unseen[mesh]))),
                                                 with_thousands(std::to_string(whole.triangles.size()))),
                             .picture = 0,
                             .bytes = mesh_bytes(whole) - mesh_bytes(*last_.scene.geometry->meshes[mesh])});
  }
  take(std::move(saving));
}

void ModelSearch::weigh_detail() {
  for (std::size_t i = 0; i < scene().geometry->meshes.size(); ++i) {
    const std::shared_ptr<const Mesh> whole = scene().geometry->meshes[i];
    if (whole->patches.empty()) continue;
    int divisions = 1, enough = 0;
    while (tessellate(whole->patches, divisions).triangles.size() < whole->triangles.size()) ++divisions;
    for (int coarser = divisions / 2; coarser >= 1; coarser /= 2) {
      Mesh less = tessellate(whole->patches, coarser);
      less.name = whole->name;
      less.materials = whole->materials;
      if (!holds(with_mesh(scene(), i, std::move(less)), settings(), Worth::lossy)) break;
      enough = coarser;
    }
    if (enough == 0) continue;
    ModelSaving saving{
        .part = ModelPart::detail,
        .goes = fmt::format("{} of {} divisions of the curved model '{}'", divisions - enough, divisions, whole->name)};
    saving.things.push_back({.name = whole->name, .bytes = model_bytes(scene()) - model_bytes(last_.scene)});
    take(std::move(saving));
  }
}

}  // namespace ps::model
