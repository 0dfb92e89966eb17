#include "raytrace/base/geometry.h"

#include <cmath>

#include <glm/matrix.hpp>

#include "accel/wide_bvh.h"
#include "base/stop.h"

namespace ps {
/// Whether each instance has triangles of its own, in the world, or shares those of its model.
enum class MeshTriangles { unfolded, shared };

namespace {

/// Beyond all coordinates of a scene, and its square is a float.
constexpr double beyond_all = 1e15;

/// Grown by what rounding to Real may move.
template <class Real>
Box<Real> traced_box(const FormBox& box) {
  Box<Real> result;
  double reach = 0;
  for (int axis = 0; axis < 3; ++axis)
    reach = std::max(
        {reach, std::min(std::abs(box.low[axis]), beyond_all), std::min(std::abs(box.high[axis]), beyond_all)});
  const double margin = 16 * static_cast<double>(std::numeric_limits<Real>::epsilon()) * reach;
  for (int axis = 0; axis < 3; ++axis) {
    result.low[axis] = static_cast<Real>(std::max(box.low[axis], -beyond_all) - margin);
    result.high[axis] = static_cast<Real>(std::min(box.high[axis], beyond_all) + margin);
  }
  return result;
}

template <class Real>
std::int32_t add_attributes(const Mesh& mesh, const MeshTriangle& corners, const std::vector<Vec3d>& world_normals,
                            TracedGeometry<Real>& geometry) {
  const auto attributes = placed_attributes<Real>(
      mesh, corners, [&](std::int32_t normal) { return world_normals.at(static_cast<std::size_t>(normal)); });
  if (!attributes.has_normals && !attributes.has_uvs) return -1;
  geometry.attributes.push_back(attributes);
  return static_cast<std::int32_t>(geometry.attributes.size()) - 1;
}

template <class Real>
void add_instance(const Scene& scene, std::int32_t object, const Instance& instance, NormalTransform normals,
                  TracedGeometry<Real>& geometry) {
  const Mesh& mesh = *scene.geometry->meshes.at(instance.mesh);
  std::vector<Vec3<Real>> positions;
  positions.reserve(mesh.positions.size());
  for (const Vec3d& position : mesh.positions) positions.push_back(placed_corner<Real>(instance.transform, position));
  geometry.one_sided_triangles = geometry.one_sided_triangles || instance.sides == Sides::front;
  const bool mirrored = mirrors(instance.transform);
  const Mat3d matrix = normal_matrix(instance.transform, normals);
  std::vector<Vec3d> world_normals;
  world_normals.reserve(mesh.normals.size());
  for (const Vec3d& normal : mesh.normals) world_normals.push_back(normal_to_world(matrix, normal));

  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (i % 4096 == 4095) check_stop();
    const MeshTriangle& corners = mesh.triangles[i];
    TracedTriangle<Real> triangle{positions.at(corners.position[0]), positions.at(corners.position[1]),
                                  positions.at(corners.position[2]), -1};
    if (!has_area(triangle)) {
      ++geometry.degenerate_triangles;
      continue;
    }
    triangle.attributes = add_attributes(mesh, corners, world_normals, geometry);
    const std::uint32_t material = instance.material ? *instance.material : mesh.materials.at(corners.material);
    geometry.primitives.push_back({{object, static_cast<std::int32_t>(i)},
                                   PrimitiveKind::triangle,
                                   static_cast<std::uint32_t>(geometry.triangles.size()),
                                   material,
                                   instance.sides == Sides::front,
                                   mirrored,
                                   asks_for_double(triangle, geometry.near_plane)});
    geometry.some_in_double = geometry.some_in_double || geometry.primitives.back().in_double;
    geometry.triangles.push_back(triangle);
  }
}

/// The same, sharing the mesh.
template <class Real>
void share_instance(std::int32_t object, const Instance& instance, NormalTransform normals,
                    TracedGeometry<Real>& geometry) {
  const Mesh& mesh = *geometry.meshes.at(instance.mesh);
  PlacedInstance placed;
  placed.object = object;
  placed.mesh = instance.mesh;
  placed.first = geometry.numbered;
  placed.front_only = instance.sides == Sides::front;
  placed.mirrored = mirrors(instance.transform);
  placed.material = instance.material;
  placed.transform = instance.transform;
  placed.normals = normal_matrix(instance.transform, normals);
  const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
  for (std::uint32_t i = 0; i < count; ++i) {
    if (i % 4096 == 4095) check_stop();
    const TracedTriangle<Real> triangle = placed_triangle<Real>(placed, mesh, i);
    if (!has_area(triangle)) {
      ++geometry.degenerate_triangles;
      continue;
    }
    for (const Vec3<Real>& corner : {triangle.a, triangle.b, triangle.c}) placed.box.include(Vec3d(corner));
    placed.in_double = placed.in_double || asks_for_double(triangle, geometry.near_plane);
  }
  geometry.one_sided_triangles = geometry.one_sided_triangles || placed.front_only;
  geometry.numbers.push_back(
      {geometry.numbered, NumberRange::Kind::instance, static_cast<std::uint32_t>(geometry.instances.size())});
  geometry.numbered += count;
  geometry.instances.push_back(placed);
}

/// Gives the primitive that was added last its number.
template <class Real>
void number_primitive(TracedGeometry<Real>& geometry) {
  geometry.numbers.push_back(
      {geometry.numbered++, NumberRange::Kind::primitive, static_cast<std::uint32_t>(geometry.primitives.size()) - 1});
}

template <class Real>
void add_steps(const CsgNode& node, TracedGeometry<Real>& geometry, std::uint32_t& parts) {
  if (node.children.empty()) {
    geometry.steps.push_back({CsgStep::Kind::part, parts++});
    return;
  }
  CsgStep::Kind kind = CsgStep::Kind::union_of;
  switch (node.operation) {
  case CsgOperation::union_of:
    break;
  case CsgOperation::intersection:
    kind = CsgStep::Kind::intersection;
    break;
  case CsgOperation::difference:
    kind = CsgStep::Kind::difference;
    break;
  }
  for (std::size_t i = 0; i < node.children.size(); ++i) {
    add_steps(node.children[i], geometry, parts);
    if (i > 0) geometry.steps.push_back({kind, 0});
  }
}

template <class Real>
std::int32_t add_place(const PartPlace& place, TracedGeometry<Real>& geometry) {
  if (place.is_identity()) return -1;
  geometry.places.push_back(
      {Mat3<Real>(inverse(place.linear)), Mat3<Real>(place.linear), Vec3<Real>(place.translation)});
  return static_cast<std::int32_t>(geometry.places.size()) - 1;
}

template <class Real>
void add_solid(std::int32_t object, const CsgNode& root, Sides sides, TracedGeometry<Real>& geometry) {
  TracedSolid solid;
  solid.first_form = static_cast<std::uint32_t>(geometry.forms.size());
  for (const Solid* part : csg_parts(root)) {
    FormFrame frame = form_frame(part->form);
    // A length that is 0 in Real would divide 0 by 0 where points are brought to the form's own scale.
    for (int axis = 0; axis < 3; ++axis)
      if (frame.half[axis] > 0)
        frame.half[axis] = std::max(frame.half[axis], static_cast<double>(std::numeric_limits<Real>::min()));
    geometry.forms.push_back({frame.kind,
                              Vec3<Real>(frame.centre),
                              {Vec3<Real>(frame.axes[0]), Vec3<Real>(frame.axes[1]), Vec3<Real>(frame.axes[2])},
                              Vec3<Real>(frame.half),
                              part->material,
                              add_place(part->place, geometry)});
  }
  solid.forms = static_cast<std::uint32_t>(geometry.forms.size()) - solid.first_form;
  solid.first_step = static_cast<std::uint32_t>(geometry.steps.size());
  std::uint32_t parts = 0;
  if (!root.children.empty()) add_steps(root, geometry, parts);
  solid.steps = static_cast<std::uint32_t>(geometry.steps.size()) - solid.first_step;
  const FormBox box = csg_box(root);
  solid.unbounded = !is_bounded(box);
  geometry.primitives.push_back({{object, 0},
                                 PrimitiveKind::solid,
                                 static_cast<std::uint32_t>(geometry.solids.size()),
                                 geometry.forms[solid.first_form].material,
                                 sides == Sides::front});
  geometry.solids.push_back(solid);
  geometry.solid_boxes.push_back(traced_box<Real>(box));
}

/// Sets what is known of all primitives together.
template <class Real>
void measure_shared(TracedGeometry<Real>& geometry) {
  Box<Real> all;
  for (const NumberRange& range : geometry.numbers) {
    if (range.kind == NumberRange::Kind::instance) {
      const Box<double>& box = geometry.instances[range.index].box;
      all.include(Box<Real>{Vec3<Real>(box.low), Vec3<Real>(box.high)});
      continue;
    }
    const Primitive& primitive = geometry.primitives[range.index];
    if (primitive.kind == PrimitiveKind::solid && geometry.solids[primitive.shape].unbounded)
      geometry.unbounded.push_back(range.first);
    else
      all.include(primitive_box(geometry, primitive));
  }
  geometry.reach = geometry.float_reach = geometry.seen.reach = all.reach();
}

template <class Real>
TracedGeometry<Real> build_geometry(const Scene& scene, NormalTransform normals, MeshTriangles meshes) {
  TracedGeometry<Real> geometry;
  geometry.near_plane = scene.camera.projection_plane_d;
  const bool shared = meshes == MeshTriangles::shared;
  if (shared) geometry.meshes = scene.geometry->meshes;
  const auto& objects = scene.geometry->objects;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    check_stop();
    const auto object = static_cast<std::int32_t>(i);
    if (const auto* sphere = std::get_if<Sphere>(&objects[i].shape)) {
      geometry.primitives.push_back({{object, 0},
                                     PrimitiveKind::sphere,
                                     static_cast<std::uint32_t>(geometry.spheres.size()),
                                     sphere->material,
                                     false});
      geometry.spheres.push_back({Vec3<Real>(sphere->centre), static_cast<Real>(sphere->radius)});
    } else if (const auto* solid = std::get_if<Solid>(&objects[i].shape)) {
      add_solid(object, {{}, {}, *solid}, solid->sides, geometry);
    } else if (const auto* csg = std::get_if<Csg>(&objects[i].shape)) {
      add_solid(object, csg->root, Sides::two, geometry);
    } else if (shared) {
      share_instance(object, std::get<Instance>(objects[i].shape), normals, geometry);
      continue;
    } else {
      add_instance(scene, object, std::get<Instance>(objects[i].shape), normals, geometry);
    }
    if (shared) number_primitive(geometry);
  }
  if (shared) {
    measure_shared(geometry);
    return geometry;
  }
  Box<Real> all, large;
  for (std::uint32_t i = 0; i < geometry.primitives.size(); ++i) {
    const Primitive& primitive = geometry.primitives[i];
    if (primitive.kind == PrimitiveKind::solid && geometry.solids[primitive.shape].unbounded)
      geometry.unbounded.push_back(i);
    else
      (primitive.in_double ? large : all).include(primitive_box(geometry, primitive));
  }
  if (!geometry.unbounded.empty())
    for (std::uint32_t i = 0, next = 0; i < geometry.primitives.size(); ++i) {
      const bool endless = next < geometry.unbounded.size() && geometry.unbounded[next] == i;
      if (endless)
        ++next;
      else
        geometry.bounded.push_back(i);
    }
  geometry.float_reach = all.reach();
  geometry.reach = std::max(all.reach(), large.reach());
  all.include(large);
  geometry.seen = seen_from(all, geometry.reach, geometry.solids.empty());
  return geometry;
}

template <class Real>
constexpr std::uint64_t precision_key = sizeof(Real);

}  // namespace

template <class Real>
Box<Real> primitive_box(const TracedGeometry<Real>& geometry, const Primitive& primitive) {
  constexpr Real infinity = std::numeric_limits<Real>::infinity();
  Box<Real> box;
  switch (primitive.kind) {
  case PrimitiveKind::sphere: {
    const TracedSphere<Real>& sphere = geometry.spheres[primitive.shape];
    for (int axis = 0; axis < 3; ++axis) {  // one step outwards covers the rounding of the sum
      box.low[axis] = std::nextafter(sphere.centre[axis] - sphere.radius, -infinity);
      box.high[axis] = std::nextafter(sphere.centre[axis] + sphere.radius, infinity);
    }
    break;
  }
  case PrimitiveKind::triangle: {
    const TracedTriangle<Real>& triangle = geometry.triangles[primitive.shape];
    box.include(triangle.a);
    box.include(triangle.b);
    box.include(triangle.c);
    break;
  }
  case PrimitiveKind::solid:
    return geometry.solid_boxes[primitive.shape];
  }
  return box;
}

template <class Real>
std::shared_ptr<const TracedGeometry<Real>> traced_geometry(const Scene& scene, const Settings& settings,
                                                            Prepared& prepared) {
  Key key("traced geometry");
  const MeshTriangles meshes =
      settings.accelerator == Accelerator::two_level ? MeshTriangles::shared : MeshTriangles::unfolded;
  key.add(scene.geometry.revision())
      .add(scene.camera.projection_plane_d)
      .add(precision_key<Real>)
      .add(settings.normal_transform)
      .add(meshes);
  return prepared.get<TracedGeometry<Real>>(
      key, [&] { return build_geometry<Real>(scene, settings.normal_transform, meshes); });
}

template <class Real>
Bvh<Real> tree_over(const TracedGeometry<Real>& geometry, const std::vector<std::uint32_t>& primitives,
                    const BvhOptions& options) {
  std::vector<Box<Real>> boxes(primitives.size());
  for_each_range(boxes.size(), options.threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) boxes[i] = primitive_box(geometry, primitive_of(geometry, primitives[i]));
  });
  Bvh<Real> bvh = build_bvh<Real>(boxes, options);
  for (std::uint32_t& entry : bvh.order) entry = primitives[entry];
  return bvh;
}

template Box<float> primitive_box(const TracedGeometry<float>&, const Primitive&);
template Box<double> primitive_box(const TracedGeometry<double>&, const Primitive&);
template std::shared_ptr<const TracedGeometry<float>> traced_geometry(const Scene&, const Settings&, Prepared&);
template std::shared_ptr<const TracedGeometry<double>> traced_geometry(const Scene&, const Settings&, Prepared&);
template Bvh<float> tree_over(const TracedGeometry<float>&, const std::vector<std::uint32_t>&, const BvhOptions&);
template Bvh<double> tree_over(const TracedGeometry<double>&, const std::vector<std::uint32_t>&, const BvhOptions&);

}  // namespace ps
