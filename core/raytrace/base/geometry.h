#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "accel/box.h"
#include "accel/bvh.h"
#include "frame/frame.h"
#include "frame/prepared.h"
#include "math/unit.h"
#include "options/settings.h"
#include "raytrace/base/placed_instance.h"
#include "raytrace/base/seen_from.h"
#include "scene/form_frame.h"
#include "scene/scene.h"

namespace ps {

template <class Real>
struct TracedSphere {
  Vec3<Real> centre{0, 0, 0};
  Real radius = 1;
};

/// The inverse of a PartPlace, which takes a ray into a part's own space; t stays what it is.
template <class Real>
struct TracedPlace {
  Mat3<Real> to_part{Real(1)};
  Mat3<Real> to_world{Real(1)};
  Vec3<Real> translation{0};

  Vec3<Real> point(const Vec3<Real>& world) const { return to_part * (world - translation); }
  /// Normals go by the inverse transpose, so that they stay normals under unequal scale and point outwards still.
  Vec3<Real> normal_to_world(const Vec3<Real>& normal) const { return normal * to_part; }
};

/// A FormFrame in the renderer's precision.
template <class Real>
struct TracedForm {
  FormKind kind = FormKind::ball;
  Vec3<Real> centre{0, 0, 0};
  std::array<Vec3<Real>, 3> axes{};
  Vec3<Real> half{1, 1, 1};
  std::uint32_t material = 0;  ///< index into Scene::materials
  std::int32_t place = -1;     ///< index into TracedGeometry::places; -1: the form lies in the world
};

/// One step of evaluating a CSG tree on a stack: push a part, or join the two topmost values.
struct CsgStep {
  enum class Kind : std::uint32_t { part, union_of, intersection, difference };
  Kind kind = Kind::part;
  std::uint32_t part = 0;
};

/// A form on its own (no steps), or a CSG tree: consecutive entries of TracedGeometry::forms and steps.
struct TracedSolid {
  std::uint32_t first_form = 0, forms = 0;
  std::uint32_t first_step = 0, steps = 0;
  bool unbounded = false;
};

enum class PrimitiveKind : std::uint32_t { sphere, triangle, solid };

/// One thing that a ray can hit. Primitives keep the order of the scene; at equal t the lower one wins.
struct Primitive {
  PixelId id;
  PrimitiveKind kind = PrimitiveKind::sphere;
  std::uint32_t shape = 0;     ///< index into spheres, triangles (where shared: instances) or solids
  std::uint32_t material = 0;  ///< index into Scene::materials; of a CSG object that of its first part
  bool front_only = false;     ///< rays that see its back pass through
  bool mirrored = false;       ///< a triangle whose front is the side from which its vertices run clockwise
  bool in_double = false;      ///< a triangle that asks_for_double()
};

/// Does a ray in this direction, if it meets the triangle, come from behind?
template <class Real>
inline bool sees_back(const Vec3<Real>& direction, const Primitive& primitive, const TracedTriangle<Real>& triangle) {
  const Real along = dot(triangle_normal(triangle.a, triangle.b, triangle.c), direction);
  return primitive.mirrored ? along <= 0 : along >= 0;
}

/// Consecutive numbers of primitives, from `first` to the next range.
struct NumberRange {
  enum class Kind : std::uint32_t { primitive, instance };
  std::uint32_t first = 0;
  Kind kind = Kind::primitive;
  std::uint32_t index = 0;  ///< into TracedGeometry::primitives or instances
};

/// The scene's geometry as rays see it, in the renderer's precision. Instances are either unfolded into world-space
/// triangles, and a primitive's number is its index; or they share their meshes, and `numbers` maps a number to its
/// instance. Both give the same triangles, to the last bit, in the same order.
template <class Real>
struct TracedGeometry {
  std::vector<Primitive> primitives;
  std::vector<PlacedInstance> instances;            ///< where meshes are shared
  std::vector<std::shared_ptr<const Mesh>> meshes;  ///< theirs; they belong to the scene
  std::vector<NumberRange> numbers;                 ///< where meshes are shared
  std::uint32_t numbered = 0;                       ///< how many numbers those are
  std::vector<TracedSphere<Real>> spheres;
  std::vector<TracedTriangle<Real>> triangles;
  std::vector<TriangleAttributes<Real>> attributes;
  std::vector<TracedForm<Real>> forms;
  std::vector<TracedPlace<Real>> places;  ///< of parts that do not lie in the world
  std::vector<TracedSolid> solids;
  std::vector<Box<Real>> solid_boxes;  ///< one for each of `solids`
  std::vector<CsgStep> steps;
  /// Unbounded primitives, such as planes. No accelerator holds them, since no box around them would
  /// keep a ray away; all others are in `bounded`, in the same order. Empty `unbounded`: `bounded` is empty too.
  std::vector<std::uint32_t> unbounded, bounded;
  bool one_sided_triangles = false;        ///< some primitives are triangles with front_only
  std::uint64_t degenerate_triangles = 0;  ///< left out, since nothing can hit them
  double near_plane = 1;                   ///< for asks_for_double()
  bool some_in_double = false;             ///< of the primitives
  Real reach = 0;                          ///< the largest absolute coordinate of any bounded primitive's box
  Real float_reach = 0;                    ///< the same without the triangles that are tested in double
  SeenFrom<Real> seen;                     ///< how the boxes of all bounded primitives are best seen

  std::size_t heap_bytes() const {
    return owned_bytes(primitives, instances, numbers, spheres, triangles, attributes, forms, places, solids,
                       solid_boxes, steps, unbounded, bounded) +
           meshes.capacity() * sizeof meshes[0];
  }
};

template <class Real>
inline bool shares_meshes(const TracedGeometry<Real>& geometry) {
  return !geometry.instances.empty();
}
/// Number of primitives, instanced ones included.
template <class Real>
inline std::uint32_t primitive_count(const TracedGeometry<Real>& geometry) {
  return geometry.numbers.empty() ? static_cast<std::uint32_t>(geometry.primitives.size()) : geometry.numbered;
}

/// Triangle `triangle` of an instance.
template <class Real>
inline Primitive placed_primitive(const TracedGeometry<Real>& geometry, std::uint32_t instance,
                                  std::uint32_t triangle) {
  const PlacedInstance& placed = geometry.instances[instance];
  const Mesh& mesh = *geometry.meshes[placed.mesh];
  const std::uint32_t own = mesh.triangles[triangle].material;
  return {{placed.object, static_cast<std::int32_t>(triangle)},
          PrimitiveKind::triangle,
          instance,
          placed.material ? *placed.material : mesh.materials[own],
          placed.front_only,
          placed.mirrored,
          placed.in_double};
}

/// The primitive with this number, where meshes are shared.
template <class Real>
Primitive shared_primitive(const TracedGeometry<Real>& geometry, std::uint32_t number) {
  const auto after = std::upper_bound(geometry.numbers.begin(), geometry.numbers.end(), number,
                                      [](std::uint32_t n, const NumberRange& range) { return n < range.first; });
  const NumberRange& range = *std::prev(after);
  if (range.kind == NumberRange::Kind::primitive) return geometry.primitives[range.index];
  return placed_primitive(geometry, range.index, number - range.first);
}

/// The primitive with this number. It is asked for with each test, so that the common case is short enough to inline.
template <class Real>
inline Primitive primitive_of(const TracedGeometry<Real>& geometry, std::uint32_t number) {
  return geometry.numbers.empty() ? geometry.primitives[number] : shared_primitive(geometry, number);
}

/// A triangle's vertices, and its attributes (for one that has some). Where meshes are shared they are made in
/// `scratch`.
template <class Real>
inline const TracedTriangle<Real>& triangle_of(const TracedGeometry<Real>& geometry, const Primitive& primitive,
                                               TracedTriangle<Real>& scratch) {
  if (!shares_meshes(geometry)) return geometry.triangles[primitive.shape];
  const PlacedInstance& placed = geometry.instances[primitive.shape];
  const Mesh& mesh = *geometry.meshes[placed.mesh];
  scratch = placed_triangle<Real>(placed, mesh, static_cast<std::uint32_t>(primitive.id.triangle));
  return scratch;
}
template <class Real>
inline const TriangleAttributes<Real>& attributes_of(const TracedGeometry<Real>& geometry, const Primitive& primitive,
                                                     const TracedTriangle<Real>& triangle,
                                                     TriangleAttributes<Real>& scratch) {
  if (!shares_meshes(geometry)) return geometry.attributes[static_cast<std::size_t>(triangle.attributes)];
  const PlacedInstance& placed = geometry.instances[primitive.shape];
  const Mesh& mesh = *geometry.meshes[placed.mesh];
  const MeshTriangle& corners = mesh.triangles[static_cast<std::uint32_t>(primitive.id.triangle)];
  scratch = placed_attributes<Real>(mesh, corners, [&](std::int32_t normal) {
    return normal_to_world(placed.normals, mesh.normals[static_cast<std::size_t>(normal)]);
  });
  return scratch;
}

/// Do the fast searches know how to test it? They know triangles in float.
inline bool is_float_triangle(const Primitive& primitive) {
  return primitive.kind == PrimitiveKind::triangle && !primitive.in_double;
}
/// Is every primitive one of those?
template <class Real>
inline bool only_float_triangles(const TracedGeometry<Real>& geometry) {
  return geometry.triangles.size() == geometry.primitives.size() && !geometry.some_in_double;
}

/// A box that certainly holds the primitive; for an infinite one a box beyond all coordinates of a scene.
template <class Real>
Box<Real> primitive_box(const TracedGeometry<Real>& geometry, const Primitive& primitive);

/// The product for this scene, which depends on its geometry and on `normal_transform`, and on whether the accelerator
/// wants meshes shared.
template <class Real>
std::shared_ptr<const TracedGeometry<Real>> traced_geometry(const Scene& scene, const Settings& settings,
                                                            Prepared& prepared);

/// How many primitives an accelerator holds, and which one is its i-th.
template <class Real>
inline std::uint32_t bounded_count(const TracedGeometry<Real>& geometry) {
  return static_cast<std::uint32_t>(geometry.unbounded.empty() ? geometry.primitives.size() : geometry.bounded.size());
}
template <class Real>
inline std::uint32_t bounded_primitive(const TracedGeometry<Real>& geometry, std::uint32_t i) {
  return geometry.unbounded.empty() ? i : geometry.bounded[i];
}

/// A tree over some of the primitives; its order holds their numbers.
template <class Real>
Bvh<Real> tree_over(const TracedGeometry<Real>& geometry, const std::vector<std::uint32_t>& primitives,
                    const BvhOptions& options = {});

}  // namespace ps
