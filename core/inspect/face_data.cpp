#include "inspect/face_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "math/unit.h"
#include "scene/world.h"

namespace ps {
namespace {

/// The mesh triangle that an id names; nullptr if it names none.
const Instance* model_of(const Scene& scene, const PixelId& id) {
  const auto& objects = scene.geometry->objects;
  if (id.object < 0 || static_cast<std::size_t>(id.object) >= objects.size() || id.triangle < 0) return nullptr;
  const auto* instance = std::get_if<Instance>(&objects[static_cast<std::size_t>(id.object)].shape);
  if (!instance) return nullptr;
  const Mesh& mesh = *scene.geometry->meshes[instance->mesh];
  return mesh.patches.empty() && static_cast<std::size_t>(id.triangle) < mesh.triangles.size() ? instance : nullptr;
}

/// Vector i of the three that `of` gives, times weight i, all added; nullopt where one is missing.
template <class Vector, class Of>
std::optional<Vector> blended(const FacePoint& point, Of of) {
  Vector sum(0);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::optional<Vector>& one = of(point.face.corners[i]);
    if (!one) return {};
    sum += point.weights[i] * *one;
  }
  return sum;
}

void add_text(std::vector<EventField>& fields, std::string_view key, std::string_view label, const std::string& text) {
  if (!text.empty()) fields.push_back({key, label, text});
}

void add_numbers(std::vector<EventField>& fields, std::string_view key, std::string_view label,
                 const std::optional<Vec3d>& v) {
  if (v) fields.push_back({key, label, std::vector{v->x, v->y, v->z}});
}

void add_numbers(std::vector<EventField>& fields, std::string_view key, std::string_view label,
                 const std::optional<Vec2d>& v) {
  if (v) fields.push_back({key, label, std::vector{v->x, v->y}});
}

/// "vertex 1", "vertices 0 and 2", "all three vertices": those whose normals face away.
std::string vertices_facing_away(const FaceData& face) {
  std::vector<std::string> away;
  for (std::size_t i = 0; i < 3; ++i)
    if (face.corners[i].faces_away) away.push_back(std::to_string(i));
  if (away.empty()) return {};
  if (away.size() == 3) return "all three vertices";
  return fmt::format("{} {}", away.size() == 1 ? "vertex" : "vertices", fmt::join(away, " and "));
}

}  // namespace

std::optional<FaceData> face_data(const Scene& scene, const PixelId& id) {
  const Instance* instance = model_of(scene, id);
  if (!instance) return {};
  const Mesh& mesh = *scene.geometry->meshes[instance->mesh];
  const auto index = static_cast<std::size_t>(id.triangle);
  const MeshTriangle& triangle = mesh.triangles[index];
  FaceData face;
  face.object = mesh.origins.object_of(index);
  face.group = mesh.origins.group_of(index);
  face.material = material_of(scene, id.object, id.triangle).name;
  face.file = mesh.source;
  if (index < mesh.origins.lines.size()) face.line = static_cast<int>(mesh.origins.lines[index]);
  const Vec3d& a = mesh.positions[triangle.position[0]];
  const Vec3d front = cross(mesh.positions[triangle.position[1]] - a, mesh.positions[triangle.position[2]] - a);
  const Mat3d to_world = normal_matrix(instance->transform, NormalTransform::inverse_transpose);
  for (std::size_t i = 0; i < 3; ++i) {
    FaceCorner& corner = face.corners[i];
    corner.vertex = static_cast<int>(triangle.position[i]);
    if (triangle.normal[i] >= 0) {
      const Vec3d& normal = mesh.normals[static_cast<std::size_t>(triangle.normal[i])];
      corner.normal = normal_to_world(to_world, normal);
      corner.faces_away = dot(normal, front) < 0;
    }
    if (triangle.uv[i] >= 0) corner.uv = mesh.uvs[static_cast<std::size_t>(triangle.uv[i])];
  }
  return face;
}

std::optional<FacePoint> face_point(const EventData& event, const Scene& scene) {
  const auto point = [&](const PixelId& id, const std::array<double, 3>& weights) -> std::optional<FacePoint> {
    auto face = face_data(scene, id);
    if (!face) return {};
    return FacePoint{std::move(*face), weights};
  };
  if (const auto* hit = std::get_if<HitEvent>(&event)) return point(hit->id, hit->weights);
  if (const auto* fragment = std::get_if<FragmentEvent>(&event)) return point(fragment->id, fragment->weights);
  return {};
}

std::optional<Vec3d> normal_at(const FacePoint& point) {
  const auto sum = blended<Vec3d>(point, [](const FaceCorner& corner) { return corner.normal; });
  if (!sum) return {};
  const Vec3d unit = unit_or_zero(*sum);
  return unit == Vec3d(0) ? std::nullopt : std::optional(unit);
}

std::optional<Vec2d> uv_at(const FacePoint& point) {
  return blended<Vec2d>(point, [](const FaceCorner& corner) { return corner.uv; });
}

std::string origin_text(const FaceData& face) {
  std::vector<std::string> parts;
  if (!face.object.empty()) parts.push_back(face.object);
  if (!face.group.empty()) parts.push_back("group " + face.group);
  if (!face.material.empty()) parts.push_back("material " + face.material);
  if (face.line > 0)
    parts.push_back(fmt::format("line {} of {}", face.line, std::filesystem::path(face.file).filename().string()));
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string facing_text(const FaceData& face) {
  const std::string away = vertices_facing_away(face);
  if (away.empty()) return {};
  const bool one = std::count_if(face.corners.begin(), face.corners.end(),
                                 [](const FaceCorner& corner) { return corner.faces_away; }) == 1;
  return fmt::format("the normal{} of {} face{} away from {} face", one ? "" : "s", away, one ? "s" : "",
                     one ? "its" : "their");
}

std::string face_words(const FaceData& face) {
  const std::string origin = origin_text(face), facing = facing_text(face);
  return origin + (origin.empty() || facing.empty() ? "" : "; ") + facing;
}

std::vector<EventField> event_fields(const EventData& event, const Scene& scene) {
  std::vector<EventField> fields = event_fields(event);
  const auto point = face_point(event, scene);
  if (!point) return fields;
  const FaceData& face = point->face;
  add_text(fields, "file-object", "object in file", face.object);
  add_text(fields, "file-group", "group in file", face.group);
  add_text(fields, "material", "", face.material);
  add_text(fields, "model-file", "", face.file);
  if (face.line > 0) fields.push_back({"face-line", "line of the face", std::int64_t{face.line}});
  std::vector<double> vertices;
  for (const FaceCorner& corner : face.corners) vertices.push_back(corner.vertex);
  fields.push_back({"vertices", "vertices of mesh", vertices});
  static constexpr std::array normal_keys{"vertex-normal-0", "vertex-normal-1", "vertex-normal-2"};
  static constexpr std::array uv_keys{"vertex-uv-0", "vertex-uv-1", "vertex-uv-2"};
  for (std::size_t i = 0; i < 3; ++i) add_numbers(fields, normal_keys[i], "", face.corners[i].normal);
  add_text(fields, "normals-away", "normals facing away", vertices_facing_away(face));
  for (std::size_t i = 0; i < 3; ++i) add_numbers(fields, uv_keys[i], "", face.corners[i].uv);
  if (std::holds_alternative<HitEvent>(event)) return fields;  // which has its normal and texture coordinates itself
  add_numbers(fields, "point-normal", "normal at point", normal_at(*point));
  add_numbers(fields, "point-uv", "uv at point", uv_at(*point));
  return fields;
}

}  // namespace ps
