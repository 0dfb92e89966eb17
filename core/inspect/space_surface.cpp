// What rays and fragments draw alike at a point of a surface.
#include "inspect/space_parts.h"
#include "scene/world.h"

namespace ps {
namespace {

constexpr double normal_share = 0.13;  // of the bounds' radius

}  // namespace

double normal_length(const SpaceBounds& bounds) { return normal_share * bounds.radius; }

void add_normal(SpaceKind kind, const Vec3d& point, const Vec3d& normal, const SpaceItem& like,
                const SpaceInputs& inputs, SpaceModel& model) {
  if (!(dot(normal, normal) > 0)) return;
  SpaceItem item = like;
  item.kind = kind;
  item.shape = SpaceShape::arrow;
  item.points = {point, point + normal * normal_length(inputs.bounds)};
  item.label.assign(kind == SpaceKind::shading_normal ? 1 : 0, 'N');
  model.items.push_back(std::move(item));
}

void add_triangle(const std::array<Vec3d, 3>& corners, const std::array<double, 3>& weights, const SpaceItem& like,
                  SpaceModel& model) {
  SpaceItem item = like;
  item.label.clear();
  const Vec3d point = corners[0] * weights[0] + corners[1] * weights[1] + corners[2] * weights[2];
  if (like.emphasised)
    for (std::size_t k = 0; k < 3; ++k) {
      SpaceItem area = item;
      area.kind = SpaceKind::barycentric_area;
      area.shape = SpaceShape::area;
      area.points = {point, corners[(k + 1) % 3], corners[(k + 2) % 3]};
      area.weight = weights[k];
      area.level = static_cast<int>(k);
      model.items.push_back(std::move(area));
    }
  item.kind = SpaceKind::triangle;
  item.shape = SpaceShape::outline;
  item.points.assign(corners.begin(), corners.end());
  model.items.push_back(std::move(item));
}

std::optional<std::array<Vec3d, 3>> world_triangle(const Scene& scene, const PixelId& id) {
  const Geometry& geometry = *scene.geometry;
  if (id.object < 0 || static_cast<std::size_t>(id.object) >= geometry.objects.size() || id.triangle < 0) return {};
  const auto* instance = std::get_if<Instance>(&geometry.objects[static_cast<std::size_t>(id.object)].shape);
  if (!instance) return {};
  const Mesh& mesh = *geometry.meshes[instance->mesh];
  if (static_cast<std::size_t>(id.triangle) >= mesh.triangles.size()) return {};
  const MeshTriangle& triangle = mesh.triangles[static_cast<std::size_t>(id.triangle)];
  std::array<Vec3d, 3> corners;
  for (std::size_t k = 0; k < 3; ++k) corners[k] = to_world(instance->transform, mesh.positions[triangle.position[k]]);
  return corners;
}

}  // namespace ps
