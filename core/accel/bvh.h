#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "accel/candidate_ray.h"
#include "base/memory_size.h"
#include "record/recorder.h"

namespace ps {

/// A node of a two-wide tree of boxes. A leaf holds `count` entries of Bvh::order from `first`; an inner node has
/// count 0 and the children `first` and `first + 1`.
template <class Real>
struct BvhNode {
  Box<Real> box;
  std::uint32_t first = 0;
  std::uint32_t count = 0;
};

/// A bounding-volume hierarchy over primitives 0 .. n - 1. Node 0 is the root; without primitives there is no node.
template <class Real>
struct Bvh {
  std::vector<BvhNode<Real>> nodes;
  std::vector<std::uint32_t> order;  ///< primitives, leaf by leaf
  Real reach = 0;                    ///< the largest absolute coordinate of any box

  std::size_t heap_bytes() const { return owned_bytes(nodes, order); }
};

inline constexpr int bvh_max_depth = 64;
/// This few primitives need no tree: the root is a leaf.
inline constexpr std::uint32_t bvh_no_tree = 8;

struct BvhOptions {
  /// Primitives that a search tests in one go, a power of two. Cuts count in these, and leaves are filled with them.
  std::uint32_t group = 4;
  int threads = 0;  ///< 0 = one per processor; the tree does not depend on it
};

/// Builds the tree from the primitives' boxes, splitting where the surface-area heuristic, estimated over bins of
/// centroids, costs least (Wald 2007).
template <class Real>
Bvh<Real> build_bvh(std::span<const Box<Real>> boxes, const BvhOptions& options = {});

/// The accelerator interface (accel/none.h). The nearer child comes first. The root is entered without a test.
template <class Real, class Visit, class Recorder>
void for_each_candidate(const Bvh<Real>& bvh, const SlabRay<Real>& ray, const Real& limit, Visit&& visit,
                        Recorder& recorder) {
  struct Waiting {
    std::uint32_t node;
    int level;
    Real near;
  };
  if (bvh.nodes.empty()) return;
  std::array<Waiting, bvh_max_depth + 1> stack;
  int waiting = 0;
  const auto report = [&](std::uint32_t index, int level, bool entered) {
    recorder.event([&] {
      const Box<Real>& box = bvh.nodes[index].box;
      return NodeEvent{static_cast<int>(index), level, Vec3d(box.low), Vec3d(box.high), entered};
    });
  };
  Waiting current{0, 0, 0};
  report(0, 0, true);
  while (true) {
    recorder.count(Counter::node_visits);
    const BvhNode<Real>& node = bvh.nodes[current.node];
    for (std::uint32_t i = 0; i < node.count; ++i)
      if (visit(bvh.order[node.first + i])) return;
    if (node.count == 0) {
      const std::uint32_t left = node.first;
      const std::uint32_t right = left + 1;
      const SlabRange<Real> left_range = slab_test(ray, bvh.nodes[left].box, limit);
      const SlabRange<Real> right_range = slab_test(ray, bvh.nodes[right].box, limit);
      const int level = current.level + 1;
      report(left, level, left_range.hit());
      report(right, level, right_range.hit());
      const Waiting left_entry{left, level, left_range.near};
      const Waiting right_entry{right, level, right_range.near};
      if (left_range.hit() && right_range.hit()) {
        const bool left_first = left_range.near <= right_range.near;
        stack[static_cast<std::size_t>(waiting++)] = left_first ? right_entry : left_entry;
        current = left_first ? left_entry : right_entry;
        continue;
      }
      if (left_range.hit() || right_range.hit()) {
        current = left_range.hit() ? left_entry : right_entry;
        continue;
      }
    }
    do {
      if (waiting == 0) return;
      current = stack[static_cast<std::size_t>(--waiting)];
    } while (current.near > limit);
  }
}
template <class Real, class Visit, class Recorder>
void for_each_candidate(const Bvh<Real>& bvh, const CandidateRay<Real>& ray, const Real& limit, Visit&& visit,
                        Recorder& recorder) {
  const bool tests_boxes = bvh.nodes.size() > 1;
  for_each_candidate(bvh, tests_boxes ? ray.slabs() : SlabRay<Real>(), limit, visit, recorder);
}

}  // namespace ps
