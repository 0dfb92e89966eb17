#include "raytrace/base/accelerators.h"

#include "accel/triangle_box.h"
#include "base/stop.h"
#include "math/unit.h"
#include "raytrace/base/coincident.h"

namespace ps {
namespace {

template <class Real>
Box<Real> box_of_all(const TracedGeometry<Real>& geometry) {
  Box<Real> box;
  for (std::uint32_t i = 0; i < bounded_count(geometry); ++i) {
    if (i % 4096 == 0) check_stop();
    box.include(primitive_box(geometry, geometry.primitives[bounded_primitive(geometry, i)]));
  }
  return box;
}

template <class Real>
BoundingSpheres make_spheres(const TracedGeometry<Real>& geometry) {
  std::vector<BoundedPrimitive> bounded;
  bounded.reserve(bounded_count(geometry));
  for (std::uint32_t i = 0; i < bounded_count(geometry); ++i) {
    if (i % 4096 == 0) check_stop();
    const Primitive& primitive = geometry.primitives[bounded_primitive(geometry, i)];
    BoundedPrimitive entry;
    entry.object = primitive.id.object;
    if (primitive.kind == PrimitiveKind::sphere) {
      const TracedSphere<Real>& sphere = geometry.spheres[primitive.shape];
      entry.centre = Vec3d(sphere.centre);
      entry.radius = static_cast<double>(sphere.radius);
    } else {
      const Box<Real> box = primitive_box(geometry, primitive);
      const Vec3d half = (Vec3d(box.high) - Vec3d(box.low)) * 0.5;
      entry.centre = (Vec3d(box.low) + Vec3d(box.high)) * 0.5;
      entry.radius = length_of(half) * (1 + 1e-14);
    }
    bounded.push_back(entry);
  }
  BoundingSpheres spheres = build_bounding_spheres(bounded);
  for (std::uint32_t& entry : spheres.order) entry = bounded_primitive(geometry, entry);
  return spheres;
}

template <class Real>
Octree<Real> make_octree(const TracedGeometry<Real>& geometry, const Settings& settings) {
  const Box<Real> all = box_of_all(geometry);
  const double slack = 64 * std::numeric_limits<double>::epsilon() * static_cast<double>(all.reach());
  const auto overlaps = [&](std::uint32_t index, const Box<Real>& cell) {
    const Primitive& primitive = geometry.primitives[bounded_primitive(geometry, index)];
    const Box<Real> box = primitive_box(geometry, primitive);
    for (int axis = 0; axis < 3; ++axis)
      if (box.low[axis] > cell.high[axis] || box.high[axis] < cell.low[axis]) return false;
    if (primitive.kind != PrimitiveKind::triangle) return true;
    const TracedTriangle<Real>& triangle = geometry.triangles[primitive.shape];
    const Box<double> wide{Vec3d(cell.low), Vec3d(cell.high)};
    return triangle_overlaps_box({Vec3d(triangle.a), Vec3d(triangle.b), Vec3d(triangle.c)}, wide, slack);
  };
  const OctreeOptions options{static_cast<std::uint32_t>(settings.octree_leaf), settings.octree_depth};
  Octree<Real> octree =
      build_octree<Real>(all, bounded_count(geometry), options, overlaps, coincident_primitives(geometry));
  for (std::uint32_t& entry : octree.entries) entry = bounded_primitive(geometry, entry);
  return octree;
}

}  // namespace

template <class Real>
TracedAccelerator<Real> traced_accelerator(const Scene& scene,
                                           const std::shared_ptr<const TracedGeometry<Real>>& traced,
                                           const Settings& settings, Prepared& prepared) {
  const TracedGeometry<Real>& geometry = *traced;
  const auto key = [&](const char* product) {
    Key made(product);
    made.add(scene.geometry.revision()).add(std::uint64_t{sizeof(Real)});
    return made;
  };
  switch (settings.accelerator) {
  case Accelerator::none:
    return NoAccelerator{primitive_count(geometry)};
  case Accelerator::bvh:
    break;
  case Accelerator::embree:
    if constexpr (std::is_same_v<Real, float>)
      if (!uses_bvh<Real>(settings)) return embree_geometry(scene, geometry, prepared);
    break;
  case Accelerator::bounding_spheres:
    return prepared.get<BoundingSpheres>(key("bounding spheres"), [&] { return make_spheres(geometry); });
  case Accelerator::box:
    return prepared.get<SingleBox<Real>>(key("box of all"), [&] {
      SingleBox<Real> box{box_of_all(geometry), {}};
      for (std::uint32_t i = 0; i < bounded_count(geometry); ++i)
        box.primitives.push_back(bounded_primitive(geometry, i));
      return box;
    });
  case Accelerator::two_level:
    return two_level(scene, geometry, prepared);
  case Accelerator::octree:
    return prepared.get<Octree<Real>>(key("octree")
                                          .add(static_cast<std::uint64_t>(settings.octree_leaf))
                                          .add(static_cast<std::uint64_t>(settings.octree_depth)),
                                      [&] { return make_octree(geometry, settings); });
  }
  return traced_bvh<Real>(scene, traced, prepared);
}

template TracedAccelerator<float> traced_accelerator(const Scene&, const std::shared_ptr<const TracedGeometry<float>>&,
                                                     const Settings&, Prepared&);
template TracedAccelerator<double>
traced_accelerator(const Scene&, const std::shared_ptr<const TracedGeometry<double>>&, const Settings&, Prepared&);

}  // namespace ps
