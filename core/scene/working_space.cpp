#include "scene/working_space.h"

#include <algorithm>
#include <cmath>

#include "math/unit.h"
#include "scene/form_frame.h"
#include "scene/object_boxes.h"

namespace ps {
namespace {

/// So many times its extent away from the world's origin, a scene keeps it. At this distance float still resolves a
/// millionth of the extent.
constexpr double most_extents_away = 8;
/// Shadow and environment maps leave out what is nearer to their middle than 0.001 units, and squares of the numbers of
/// small scenes leave float's range.
constexpr double least_extent = 0x1p-2;
/// Fourth powers of this are floats: products of two squares occur.
constexpr double greatest_extent = 0x1p30;

void move_form(Form& form, const WorkingSpace& space) {
  const double k = space.scale;
  if (auto* ball = std::get_if<Ball>(&form)) {
    *ball = {space.from_world(ball->centre), ball->radius * k};
  } else if (auto* plane = std::get_if<Plane>(&form)) {
    plane->point = space.from_world(plane->point);
  } else if (auto* rectangle = std::get_if<Rectangle>(&form)) {
    *rectangle = {space.from_world(rectangle->corner), rectangle->side_a * k, rectangle->side_b * k};
  } else if (auto* brick = std::get_if<Brick>(&form)) {
    brick->centre = space.from_world(brick->centre);
    brick->size *= k;
  } else if (auto* cylinder = std::get_if<Cylinder>(&form)) {
    *cylinder = {space.from_world(cylinder->from), space.from_world(cylinder->to), cylinder->radius * k};
  }
}

/// A form that has a place moves to the origin of its own space, and the place takes on the rest: both may be far away.
void move_solid(Solid& solid, const WorkingSpace& space) {
  if (solid.place.is_identity()) return move_form(solid.form, space);
  const Vec3d centre = form_frame(solid.form).centre;
  move_form(solid.form, {centre, 1});
  solid.place.translation = space.from_world(solid.place.linear * centre + solid.place.translation);
  solid.place.linear *= space.scale;
}

}  // namespace

WorkingSpace working_space(const std::vector<FormBox>& boxes, const Vec3d& eye) {
  WorkingSpace space;
  FormBox box{eye, eye};
  for (const FormBox& one : boxes) {
    if (!is_bounded(one)) continue;
    include_point(box, one.low);
    include_point(box, one.high);
  }
  const Vec3d middle = box.low * 0.5 + box.high * 0.5;
  const double extent = largest_component(box.high * 0.5 - box.low * 0.5), away = largest_component(middle);
  if (!std::isfinite(away) || !std::isfinite(extent)) return space;
  if (away > most_extents_away * extent && away > 0) {
    const double step = std::ldexp(1, std::ilogb(std::max(extent, away * 0x1p-40)) + 1);
    for (int axis = 0; axis < 3; ++axis) space.origin[axis] = std::round(middle[axis] / step) * step;
  }
  if (extent > 0 && extent < least_extent) space.scale = std::ldexp(1, -std::ilogb(extent));
  if (extent > greatest_extent) space.scale = std::ldexp(greatest_extent, -1 - std::ilogb(extent));
  return space;
}

WorkingSpace working_space(const Scene& scene) {
  if (scene.geometry->objects.empty()) return {};
  return working_space(boxes_of_objects(*scene.geometry), scene.camera.position);
}

Geometry moved(const Geometry& geometry, const WorkingSpace& space) {
  Geometry result = geometry;
  for (Object& object : result.objects) {
    if (auto* sphere = std::get_if<Sphere>(&object.shape)) {
      sphere->centre = space.from_world(sphere->centre);
      sphere->radius *= space.scale;
    } else if (auto* solid = std::get_if<Solid>(&object.shape)) {
      move_solid(*solid, space);
    } else if (auto* csg = std::get_if<Csg>(&object.shape)) {
      for (Solid* part : csg_parts(csg->root)) move_solid(*part, space);
    } else if (auto* instance = std::get_if<Instance>(&object.shape)) {
      instance->transform.translation = space.from_world(instance->transform.translation);
      instance->transform.scale *= space.scale;
    }
  }
  return result;
}

std::vector<Light> moved(const std::vector<Light>& lights, const WorkingSpace& space) {
  std::vector<Light> result = lights;
  for (Light& light : result) {
    light.position = space.from_world(light.position);
    light.direction *= space.scale;
    light.radius *= space.scale;
    light.attenuation.y /= space.scale;
    light.attenuation.z /= space.scale * space.scale;
  }
  return result;
}

Camera moved(const Camera& camera, const WorkingSpace& space) {
  Camera result = camera;
  result.position = space.from_world(camera.position);
  result.viewport_width *= space.scale;
  result.viewport_height *= space.scale;
  result.projection_plane_d *= space.scale;
  return result;
}

}  // namespace ps
