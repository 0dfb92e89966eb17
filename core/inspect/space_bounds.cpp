#include <algorithm>
#include <cmath>
#include <limits>

#include "inspect/space_parts.h"
#include "scene/form_frame.h"
#include "scene/world.h"

namespace ps {
namespace {

/// A sphere this many times larger than the eye's distance from its surface, or than the rest, is taken for the ground.
constexpr double ground_factor = 20;

struct Extent {
  Vec3d low{std::numeric_limits<double>::infinity()};
  Vec3d high{-std::numeric_limits<double>::infinity()};
  std::vector<SpaceBall> parts;

  void take(const Vec3d& point, double around = 0) {
    for (int k = 0; k < 3; ++k) {
      if (!std::isfinite(point[k])) return;
    }
    low = glm::min(low, point - Vec3d(around));
    high = glm::max(high, point + Vec3d(around));
    parts.push_back({point, around});
  }
  SpaceBounds bounds() const {
    const Vec3d half = (high - low) * 0.5;
    return {low + half, std::max(std::sqrt(dot(half, half)), 1e-6), parts};
  }
};

bool serves_as_ground(const Sphere& sphere, const Vec3d& eye) {
  const Vec3d to_eye = eye - sphere.centre;
  return sphere.radius > ground_factor * std::abs(std::sqrt(dot(to_eye, to_eye)) - sphere.radius);
}

/// Endless shapes, such as planes, have no extent to look at.
void take_box(const FormBox& box, Extent& extent) {
  if (!is_bounded(box)) return;
  const Vec3d half = (box.high - box.low) * 0.5;
  extent.take(box.low + half, std::sqrt(dot(half, half)));
}

void take_objects(const SpaceInputs& inputs, Extent& extent) {
  for (const Object& object : inputs.scene.geometry->objects) {
    if (const auto* sphere = std::get_if<Sphere>(&object.shape)) {
      if (!serves_as_ground(*sphere, inputs.view.camera.position)) extent.take(sphere->centre, sphere->radius);
      continue;
    }
    if (const auto* solid = std::get_if<Solid>(&object.shape)) {
      take_box(solid_box(*solid), extent);
      continue;
    }
    if (const auto* csg = std::get_if<Csg>(&object.shape)) {
      take_box(csg_box(csg->root), extent);
      continue;
    }
    const auto& instance = std::get<Instance>(object.shape);
    const BoundingSphere bound = bounding_sphere(*inputs.scene.geometry->meshes[instance.mesh]);
    const Vec3d scale = glm::abs(instance.transform.scale);
    extent.take(to_world(instance.transform, bound.centre), bound.radius * std::max({scale.x, scale.y, scale.z}));
  }
}

}  // namespace

std::vector<bool> ground_objects(const SpaceInputs& inputs) {
  std::vector<bool> ground;
  for (const Object& object : inputs.scene.geometry->objects) {
    const auto* sphere = std::get_if<Sphere>(&object.shape);
    ground.push_back(sphere && serves_as_ground(*sphere, inputs.view.camera.position));
  }
  return ground;
}

SpaceBounds space_bounds(const SpaceInputs& inputs) {
  Extent extent;
  extent.take(inputs.view.camera.position);
  const double w = inputs.image.columns(), h = inputs.image.rows();
  for (const Vec2d& corner : {Vec2d(0, 0), Vec2d(w, 0), Vec2d(0, h), Vec2d(w, h)}) extent.take(inputs.image.at(corner));
  take_objects(inputs, extent);
  // Lights far away would shrink everything else to a dot; the view may be moved to them.
  const SpaceBounds seen = extent.bounds();
  for (const Light& light : *inputs.scene.lights) {
    const Vec3d away = light.position - seen.centre;
    if (light.kind == LightKind::point && std::sqrt(dot(away, away)) < 2 * seen.radius) extent.take(light.position);
  }
  return extent.bounds();
}

}  // namespace ps
