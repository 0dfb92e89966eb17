#include "scene/working_space.h"

#include <algorithm>
#include <cmath>

#include "base/stop.h"
#include "math/unit.h"
#include "scene/form_frame.h"
#include "scene/world.h"

namespace ps {
namespace {

/// So many times its extent away from the world's origin, a scene keeps it. At this distance float still resolves a
/// millionth of the extent.
constexpr double most_extents_away = 8;
constexpr double least_extent = 0x1p-20;
/// Fourth powers of this are floats: products of two squares occur.
constexpr double greatest_extent = 0x1p30;

void include_point(FormBox& box, const Vec3d& point) {
  box.low = glm::min(box.low, point);
  box.high = glm::max(box.high, point);
}

/// Around the vertices that triangles use.
FormBox box_of_used(const Mesh& mesh) {
  FormBox box;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (i % 4096 == 4095) check_stop();
    for (const std::uint32_t corner : mesh.triangles[i].position) include_point(box, mesh.positions[corner]);
  }
  return box;
}

Vec3d corner_of(const FormBox& box, int corner) {
  return {((corner & 1) != 0 ? box.high : box.low).x, ((corner & 2) != 0 ? box.high : box.low).y,
          ((corner & 4) != 0 ? box.high : box.low).z};
}

/// A box around each object; not bounded where an object has none. Of a plane the point that it is given by.
class BoxesOfObjects {
 public:
  explicit BoxesOfObjects(const Geometry& geometry) : geometry_(geometry), meshes_(geometry_.meshes.size()) {
    for (const Object& object : geometry_.objects) {
      check_stop();
      boxes.push_back(std::visit([&](const auto& shape) { return box_of(shape); }, object.shape));
    }
  }
  std::vector<FormBox> boxes;

 private:
  static FormBox box_of(const Sphere& sphere) { return {sphere.centre - sphere.radius, sphere.centre + sphere.radius}; }
  static FormBox box_of(const Solid& solid) {
    const auto* plane = std::get_if<Plane>(&solid.form);
    if (!plane) return solid_box(solid);
    const Vec3d point = solid.place.linear * plane->point + solid.place.translation;
    return {point, point};
  }
  static FormBox box_of(const Csg& csg) { return csg_box(csg.root); }
  FormBox box_of(const Instance& instance) {
    FormBox& own = meshes_[instance.mesh];
    if (!is_bounded(own)) own = box_of_used(*geometry_.meshes[instance.mesh]);
    FormBox box;
    if (is_bounded(own))  // it has triangles
      for (int corner = 0; corner < 8; ++corner)
        include_point(box, ps::to_world(instance.transform, corner_of(own, corner)));
    return box;
  }

  const Geometry& geometry_;
  std::vector<FormBox> meshes_;  ///< by mesh; unbounded: not asked for yet
};

WorkingSpace space_around(const std::vector<FormBox>& boxes, const Vec3d& eye) {
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

/// From a point to a box; 0 within.
double distance_to(const FormBox& box, const Vec3d& point) {
  return length_of(glm::max(glm::max(box.low - point, point - box.high), Vec3d(0)));
}

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

WorkingSpace working_space(const Scene& scene) {
  if (scene.geometry->objects.empty()) return {};
  return space_around(BoxesOfObjects(*scene.geometry).boxes, scene.camera.position);
}

bool outgrows_float(const Scene& scene) {
  constexpr double float_step = 0x1p-24, seen = 0x1p-10;  // the rounding, and the share of a size that is seen
  if (scene.geometry->objects.empty()) return false;
  const std::vector<FormBox> boxes = BoxesOfObjects(*scene.geometry).boxes;
  const Camera& camera = scene.camera;
  const Vec3d& eye = camera.position;
  const WorkingSpace space = space_around(boxes, eye);
  const double pixel = camera.viewport_height / camera.projection_plane_d / scene.canvas_height;  // at distance 1
  const double eye_error = float_step * largest_component(eye - space.origin);
  const double near = camera.projection_plane_d * 0x1p-6;
  return std::any_of(boxes.begin(), boxes.end(), [&](const FormBox& box) {
    if (!is_bounded(box)) return false;
    const double size = largest_component(box.high - box.low), distance = distance_to(box, eye);
    const double reach =
        std::max(largest_component(box.low - space.origin), largest_component(box.high - space.origin));
    if (distance > 0 && eye_error > seen * std::max(distance, near)) return true;
    return size > pixel * distance && std::max(float_step * reach, eye_error) > seen * size && size > 0;
  });
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
