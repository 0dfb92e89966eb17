#include "gui/session/camera_moves.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

#include "scene/form_frame.h"

namespace ps::gui {
namespace {

constexpr double ground_radius = 500;                       // a sphere beyond this is taken for the ground
constexpr double steepest = 85 * std::numbers::pi / 180.0;  // nearest to straight up or down

Mat3d rotation(const Vec3d& axis, double angle) { return Mat3d(glm::rotate(Mat4d(1.0), angle, axis)); }

/// The rotation about `axis` by `angle` that carries `from` towards `towards`.
Mat3d rotation_towards(const Vec3d& axis, double angle, const Vec3d& from, const Vec3d& towards) {
  const double sense = dot(cross(axis, from), towards) < 0 ? -1.0 : 1.0;
  return rotation(axis, angle * sense);
}

void apply(Camera& camera, const Mat3d& by) {
  camera.right = by * camera.right;
  camera.up = by * camera.up;
  camera.forward = by * camera.forward;
}

/// How far the camera looks above the horizon, in radians.
double elevation(const Camera& camera, const Vec3d& world_up) {
  const double lengths = glm::length(camera.forward) * glm::length(world_up);
  return std::asin(std::clamp(dot(camera.forward, world_up) / lengths, -1.0, 1.0));
}

}  // namespace

Camera turned(const Camera& camera, double to_right, double upwards, const Vec3d& world_up) {
  Camera result = camera;
  if (to_right != 0) apply(result, rotation_towards(glm::normalize(world_up), to_right, result.forward, result.right));
  const double now = elevation(result, world_up);
  // A scene may start out steeper than the limit; it is not pulled back, only kept from going on.
  const double allowed = std::clamp(upwards, std::min(-steepest - now, 0.0), std::max(steepest - now, 0.0));
  if (allowed != 0) apply(result, rotation_towards(glm::normalize(result.right), allowed, result.forward, result.up));
  return result;
}

Camera orbited(const Camera& camera, double to_right, double upwards, const Vec3d& world_up, const Vec3d& pivot) {
  const Camera aimed = turned(camera, to_right, upwards, world_up);
  // The turn of the frame, applied to the arm from the pivot to the camera as well.
  const Mat3d before(camera.right, camera.up, camera.forward);
  const Mat3d after(aimed.right, aimed.up, aimed.forward);
  Camera result = aimed;
  result.position = pivot + after * glm::inverse(before) * (camera.position - pivot);
  return result;
}

Camera moved(const Camera& camera, double right, double up, double forward) {
  Camera result = camera;
  result.position +=
      glm::normalize(camera.right) * right + glm::normalize(camera.up) * up + glm::normalize(camera.forward) * forward;
  return result;
}

Vec3d scene_centre(const Scene& scene) {
  Vec3d sum(0, 0, 0);
  int count = 0;
  for (const auto& object : scene.geometry->objects) {
    if (const auto* sphere = std::get_if<Sphere>(&object.shape)) {
      if (sphere->radius > ground_radius) continue;
      sum += sphere->centre;
    } else if (const auto* solid = std::get_if<Solid>(&object.shape)) {
      const FormBox box = solid_box(*solid);
      if (!is_bounded(box)) continue;
      sum += (box.low + box.high) * 0.5;
    } else if (const auto* csg = std::get_if<Csg>(&object.shape)) {
      const FormBox box = csg_box(csg->root);
      if (!is_bounded(box)) continue;
      sum += (box.low + box.high) * 0.5;
    } else {
      const auto& instance = std::get<Instance>(object.shape);
      const auto bound = bounding_sphere(*scene.geometry->meshes[instance.mesh]);
      const auto& place = instance.transform;
      sum += place.rotation * (place.scale * bound.centre) + place.translation;
    }
    ++count;
  }
  if (count == 0) return scene.camera.position + scene.camera.forward;
  return sum / static_cast<double>(count);
}

double scene_reach(const Scene& scene, const Camera& camera) {
  return std::max(glm::length(scene_centre(scene) - camera.position), 1e-3);
}

Light moved_light(const Light& light, const Camera& camera, double right, double up, double forward, double reach) {
  const Vec3d step =
      glm::normalize(camera.right) * right + glm::normalize(camera.up) * up + glm::normalize(camera.forward) * forward;
  Light result = light;
  switch (light.kind) {
  case LightKind::ambient:
    break;
  case LightKind::point:
    result.position += step;
    break;
  case LightKind::directional: {
    const double length = glm::length(light.direction);
    const Vec3d moved = light.direction + step / reach * length;
    if (glm::length(moved) > 0) result.direction = glm::normalize(moved) * length;
    break;
  }
  }
  return result;
}

}  // namespace ps::gui
