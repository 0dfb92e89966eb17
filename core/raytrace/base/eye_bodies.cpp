#include "raytrace/base/eye_bodies.h"

#include <algorithm>

#include "scene/world.h"

namespace ps {
namespace {

bool lets_light_through(const Scene& scene, std::uint32_t material) {
  return scene.materials->at(material).transparency > 0;
}

bool any_part_lets_light_through(const Scene& scene, const Object& object) {
  const auto through = [&](std::uint32_t material) { return lets_light_through(scene, material); };
  if (const auto* sphere = std::get_if<Sphere>(&object.shape)) return through(sphere->material);
  if (const auto* solid = std::get_if<Solid>(&object.shape)) return !is_flat(solid->form) && through(solid->material);
  if (const auto* csg = std::get_if<Csg>(&object.shape)) {
    const auto parts = csg_parts(csg->root);
    return std::any_of(parts.begin(), parts.end(), [&](const Solid* part) { return through(part->material); });
  }
  const auto& instance = std::get<Instance>(object.shape);
  if (instance.material) return through(*instance.material);
  const auto& materials = scene.geometry->meshes.at(instance.mesh)->materials;
  return std::any_of(materials.begin(), materials.end(), through);
}

FormBox box_of_body(const Scene& scene, const Object& object) {
  FormBox box;
  if (const auto* sphere = std::get_if<Sphere>(&object.shape))
    return {sphere->centre - sphere->radius, sphere->centre + sphere->radius};
  if (const auto* solid = std::get_if<Solid>(&object.shape)) return solid_box(*solid);
  if (const auto* csg = std::get_if<Csg>(&object.shape)) return csg_box(csg->root);
  const auto& instance = std::get<Instance>(object.shape);
  for (const Vec3d& position : scene.geometry->meshes.at(instance.mesh)->positions) {
    const Vec3d p = to_world(instance.transform, position);
    box.low = glm::min(box.low, p);
    box.high = glm::max(box.high, p);
  }
  return box;
}

bool comes_within(const FormBox& box, const Vec3d& point, double reach) {
  for (int axis = 0; axis < 3; ++axis)
    if (!(box.low[axis] - reach <= point[axis] && point[axis] <= box.high[axis] + reach)) return false;
  return true;
}

/// The number of the primitive that an object without triangles is.
template <class Real>
std::optional<std::uint32_t> number_of_object(const TracedGeometry<Real>& geometry, std::int32_t object) {
  const auto is_it = [&](const Primitive& primitive) {
    return primitive.kind != PrimitiveKind::triangle && primitive.id.object == object;
  };
  if (geometry.numbers.empty()) {
    const auto found = std::find_if(geometry.primitives.begin(), geometry.primitives.end(), is_it);
    if (found == geometry.primitives.end()) return {};
    return static_cast<std::uint32_t>(found - geometry.primitives.begin());
  }
  for (const NumberRange& range : geometry.numbers)
    if (range.kind == NumberRange::Kind::primitive && is_it(geometry.primitives[range.index])) return range.first;
  return {};
}

}  // namespace

template <class Real>
std::vector<EyeBody> eye_bodies(const Scene& scene, const TracedGeometry<Real>& geometry, double reach,
                                const Vec3d& eye) {
  std::vector<EyeBody> bodies;
  const auto& objects = scene.geometry->objects;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    if (!any_part_lets_light_through(scene, objects[i])) continue;
    if (!comes_within(box_of_body(scene, objects[i]), eye, reach)) continue;
    EyeBody body;
    body.object = static_cast<std::int32_t>(i);
    if (!std::holds_alternative<Instance>(objects[i].shape)) body.primitive = number_of_object(geometry, body.object);
    bodies.push_back(body);
  }
  return bodies;
}

template std::vector<EyeBody> eye_bodies(const Scene&, const TracedGeometry<float>&, double, const Vec3d&);
template std::vector<EyeBody> eye_bodies(const Scene&, const TracedGeometry<double>&, double, const Vec3d&);

}  // namespace ps
