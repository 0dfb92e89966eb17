#pragma once
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "accel/candidate_ray.h"
#include "base/memory_size.h"
#include "record/recorder.h"

namespace ps {

/// A sphere around part of the scene. A leaf holds `count` entries of BoundingSpheres::order from `first`; an inner
/// node has count 0 and the children `first` and `first + 1`.
struct SphereNode {
  Vec3d centre{0};
  double radius = 0;
  std::uint32_t first = 0;
  std::uint32_t count = 0;
};

/// Bounding spheres (CGFS ch. 5): one around each object, spheres around pairs of neighbouring objects above them, and
/// below them spheres around the halves of an object of many primitives. Node 0 is the root.
struct BoundingSpheres {
  std::vector<SphereNode> nodes;
  std::vector<std::uint32_t> order;  ///< primitives, leaf by leaf

  std::size_t heap_bytes() const { return owned_bytes(nodes, order); }
};

/// The bounds of a primitive: a sphere that holds it, and its object (equal numbers are together).
struct BoundedPrimitive {
  Vec3d centre{0};
  double radius = 0;
  std::int32_t object = 0;
};
BoundingSpheres build_bounding_spheres(std::span<const BoundedPrimitive> primitives);

inline constexpr int sphere_tree_depth = 64;  ///< halving 2^32 objects of 2^32 primitives

/// Where the ray is inside the sphere, grown by four paddings; near > far where it never is.
template <class Real>
SlabRange<double> sphere_range(const SphereNode& node, const CandidateRay<Real>& ray) {
  const Vec3d direction(ray.direction);
  const Vec3d from_centre = Vec3d(ray.origin) - node.centre;
  const double a = dot(direction, direction);
  const double middle = -dot(from_centre, direction) / a;
  const Vec3d nearest = from_centre + direction * middle;
  const double radius = node.radius + 4 * static_cast<double>(ray.pad);
  const double left = radius * radius - dot(nearest, nearest);
  if (left < 0) return {1, 0};
  const double half = std::sqrt(left / a);
  const double near = middle - half, far = middle + half;
  return {near > 0 ? near : 0, far};
}

/// The accelerator interface (accel/none.h). The nearer sphere comes first.
template <class Real, class Visit, class Recorder>
void for_each_candidate(const BoundingSpheres& spheres, const CandidateRay<Real>& ray, const Real& limit, Visit&& visit,
                        Recorder& recorder) {
  struct Waiting {
    std::uint32_t node;
    int level;
    double near;
  };
  std::array<Waiting, 2 * sphere_tree_depth> stack;
  int waiting = 0;
  const auto meet = [&](std::uint32_t index, int level) {
    const SphereNode& node = spheres.nodes[index];
    const SlabRange<double> range = sphere_range(node, ray);
    const bool entered = !(range.near > range.far) && !(range.near > static_cast<double>(limit));
    recorder.event([&] {
      NodeEvent event{static_cast<int>(index), level, node.centre - node.radius, node.centre + node.radius, entered};
      event.radius = node.radius;
      return event;
    });
    if (entered) stack[static_cast<std::size_t>(waiting++)] = {index, level, range.near};
  };
  if (!spheres.nodes.empty()) meet(0, 0);
  while (waiting > 0) {
    const Waiting current = stack[static_cast<std::size_t>(--waiting)];
    if (current.near > static_cast<double>(limit)) continue;
    recorder.count(Counter::node_visits);
    const SphereNode& node = spheres.nodes[current.node];
    for (std::uint32_t i = 0; i < node.count; ++i)
      if (visit(spheres.order[node.first + i])) return;
    if (node.count > 0) continue;
    const int before = waiting;
    meet(node.first, current.level + 1);
    meet(node.first + 1, current.level + 1);
    if (waiting == before + 2) {
      Waiting& first = stack[static_cast<std::size_t>(before)];
      Waiting& second = stack[static_cast<std::size_t>(before) + 1];
      if (first.near < second.near) std::swap(first, second);
    }
  }
}

}  // namespace ps
