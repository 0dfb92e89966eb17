#include "textbook/near_pixel.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "textbook/book_math.h"

namespace ps {
namespace {

constexpr double pixels_around = 2;

/// Where the vertices are on the canvas, in pixels from the picked one; no numbers for those behind the camera.
std::vector<Vec2d> places_from_pixel(const BookScene& scene, const BookInstance& instance, Vec2i pixel) {
  const Camera& camera = scene.camera;
  const Mat4d to_camera = world_to_camera(camera) * model_to_world(instance.instance->transform);
  const Vec2d scale{camera.projection_plane_d * scene.width / camera.viewport_width,
                    camera.projection_plane_d * scene.height / camera.viewport_height};
  std::vector<Vec2d> places;
  places.reserve(instance.model->positions.size());
  for (const Vec3d& position : instance.model->positions) {
    const Vec3d seen = transform(to_camera, position);
    places.push_back(seen.z > 0 ? Vec2d(seen) * scale / seen.z - Vec2d(pixel)
                                : Vec2d(std::numeric_limits<double>::quiet_NaN()));
  }
  return places;
}

/// Whether the box around three places comes near to 0. A place that is NaN never keeps it away.
bool comes_near(double a, double b, double c) {
  if (std::isnan(a) || std::isnan(b) || std::isnan(c)) return true;
  return std::min({a, b, c}) <= pixels_around && std::max({a, b, c}) >= -pixels_around;
}

template <class Value>
std::int32_t append(const std::vector<Value>& from, std::int32_t index, std::vector<Value>& to) {
  if (index < 0) return index;
  to.push_back(from[static_cast<std::size_t>(index)]);
  return static_cast<std::int32_t>(to.size()) - 1;
}

}  // namespace

MeshPart part_near_pixel(const BookScene& scene, const BookInstance& instance, Vec2i pixel) {
  const Mesh& whole = *instance.model;
  const std::vector<Vec2d> places = places_from_pixel(scene, instance, pixel);
  MeshPart part;
  part.mesh.name = whole.name;
  part.mesh.materials = whole.materials;
  for (std::size_t i = 0; i < whole.triangles.size(); ++i) {
    MeshTriangle triangle = whole.triangles[i];
    const Vec2d &a = places[triangle.position[0]], &b = places[triangle.position[1]], &c = places[triangle.position[2]];
    if (!comes_near(a.x, b.x, c.x) || !comes_near(a.y, b.y, c.y)) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      part.mesh.positions.push_back(whole.positions[triangle.position[k]]);
      triangle.position[k] = static_cast<std::uint32_t>(part.mesh.positions.size()) - 1;
      triangle.normal[k] = append(whole.normals, triangle.normal[k], part.mesh.normals);
      triangle.uv[k] = append(whole.uvs, triangle.uv[k], part.mesh.uvs);
    }
    part.mesh.triangles.push_back(triangle);
    part.numbers.push_back(static_cast<std::uint32_t>(i));
  }
  return part;
}

}  // namespace ps
