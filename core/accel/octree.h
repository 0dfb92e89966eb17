#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "accel/candidate_ray.h"
#include "base/memory_size.h"
#include "record/recorder.h"

namespace ps {

/// A cell. A leaf (`leaf`) lists `count` entries of Octree::entries from `first`; others have the children `first` ..
/// `first + 7`, child i above the centre on the axes whose bit is set in i.
template <class Real>
struct OctreeNode {
  Box<Real> box;
  std::uint32_t first = 0;
  std::uint32_t count = 0;
  bool leaf = true;
  std::uint8_t filled = 0;  ///< bit i: something lies in child i
};

/// The centre of a cell, where its children meet.
template <class Real>
Vec3<Real> middle_of(const Box<Real>& box) {
  return box.low * Real(0.5) + box.high * Real(0.5);
}

/// Space cut into eight equal parts, again and again. A primitive is in every leaf that it touches, so it may be
/// visited more than once.
template <class Real>
struct Octree {
  std::vector<OctreeNode<Real>> nodes;  ///< node 0 is the root
  std::vector<std::uint32_t> entries;

  std::size_t heap_bytes() const { return owned_bytes(nodes, entries); }
};

struct OctreeOptions {
  std::uint32_t leaf = 8;  ///< a cell with more primitives is cut
  int depth = 10;          ///< but no deeper than this
};
inline constexpr int octree_max_depth = 16;

/// `overlaps(primitive, cell)`: may the primitive touch the cell? It must say yes to every cell that holds a point of
/// it. `coincident`, empty or one number for each primitive: the first one in the very same place, or itself. No depth
/// separates those, so OctreeOptions::leaf counts them as one. Where cells would list far more than the primitives that
/// there are (64 times as many; 8 times for more than 800,000), cells whose children list the most more stay leaves.
/// Throws Cancelled (base/stop.h).
template <class Real>
Octree<Real> build_octree(const Box<Real>& box, std::uint32_t primitives, const OctreeOptions& options,
                          const std::function<bool(std::uint32_t, const Box<Real>&)>& overlaps,
                          std::span<const std::uint32_t> coincident = {});

/// slab_test() for all eight children of a cell: they share nine planes, so no plane is met twice. Children are counted
/// from the one whose corner the ray comes from: bit k set = the farther half along axis k.
template <class Real>
class ChildSlabs {
 public:
  ChildSlabs(const SlabRay<Real>& ray, const Box<Real>& box, Real limit) : limit_(limit) {
    const Vec3<Real> middle = middle_of(box);
    set_axis(ray, 0, box.low.x, middle.x, box.high.x);
    set_axis(ray, 1, box.low.y, middle.y, box.high.y);
    set_axis(ray, 2, box.low.z, middle.z, box.high.z);
  }
  /// Bit i: the ray may meet child i. Halves that it reaches too late, or leaves too early, are left out.
  unsigned candidates() const {
    Real enter = 0, leave = limit_;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (near_[axis][0] > enter) enter = near_[axis][0];
      if (far_[axis][1] < leave) leave = far_[axis][1];
    }
    constexpr std::array<unsigned, 3> farther{0xaau, 0xccu, 0xf0u};
    unsigned result = 0xffu;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (near_[axis][1] > leave) result &= ~farther[axis];
      if (far_[axis][0] < enter) result &= farther[axis];
    }
    return result;
  }
  SlabRange<Real> operator()(std::uint32_t child) const {
    SlabRange<Real> range{0, limit_};
    const auto narrow = [&](Real near, Real far) {
      if (near > range.near) range.near = near;
      if (far < range.far) range.far = far;
    };
    narrow(near_[0][child & 1u], far_[0][child & 1u]);
    narrow(near_[1][child >> 1 & 1u], far_[1][child >> 1 & 1u]);
    narrow(near_[2][child >> 2], far_[2][child >> 2]);
    return range;
  }

 private:
  void set_axis(const SlabRay<Real>& ray, int axis, Real low, Real middle, Real high) {
    const auto i = static_cast<std::size_t>(axis);
    for (Real* const plane : {&low, &middle, &high}) *plane -= ray.origin[axis];
    const Real entering = ray.entering[axis], leaving = ray.leaving[axis], inverse = ray.inverse[axis];
    const bool down = ray.negative[i];
    near_[i][0] = ((down ? high : low) - entering) * inverse;
    near_[i][1] = (middle - entering) * inverse;
    far_[i][0] = ((middle - leaving) * inverse) * slab_growth<Real>;
    far_[i][1] = (((down ? low : high) - leaving) * inverse) * slab_growth<Real>;
  }
  std::array<std::array<Real, 2>, 3> near_, far_;  ///< by axis, of the nearer and the farther half
  Real limit_;
};

/// The accelerator interface (accel/none.h). Cells are entered from near to far: child i before child k wherever the
/// ray can reach k from i. A hit may lie behind the cell that found it; it ends the search only for cells that begin
/// behind the hit.
template <class Real, class Visit, class Recorder>
void for_each_candidate(const Octree<Real>& octree, const CandidateRay<Real>& ray, const Real& limit, Visit&& visit,
                        Recorder& recorder) {
  if (octree.nodes.empty()) return;
  constexpr std::size_t most = 7 * octree_max_depth + 8;
  std::array<std::uint32_t, most> waiting;  // with its level and where the ray enters it; apart, for speed
  std::array<int, most> levels;
  std::array<Real, most> nears;
  std::size_t top = 0;
  const auto report = [&](std::uint32_t index, int level, bool entered) {
    recorder.event([&] {
      const Box<Real>& box = octree.nodes[index].box;
      return NodeEvent{static_cast<int>(index), level, Vec3d(box.low), Vec3d(box.high), entered};
    });
  };
  const SlabRay<Real> slab_ray = ray.slabs();
  const bool whole = slab_test(slab_ray, octree.nodes[0].box, limit).hit();
  report(0, 0, whole);
  if (!whole) return;
  const bool naive = ray.form == SlabForm::naive;
  const std::array<bool, 3>& down = slab_ray.negative;
  const std::uint32_t nearest_child = (down[0] ? 1u : 0u) | (down[1] ? 2u : 0u) | (down[2] ? 4u : 0u);
  std::uint32_t current = 0;
  int level = 0;
  while (true) {
    recorder.count(Counter::node_visits);
    const OctreeNode<Real>& node = octree.nodes[current];
    if (node.leaf) {
      for (std::uint32_t i = 0; i < node.count; ++i)
        if (visit(octree.entries[node.first + i])) return;
    } else {
      const ChildSlabs<Real> slabs(slab_ray, node.box, limit);
      const auto is_filled = [&](std::uint32_t i) { return (node.filled >> (i ^ nearest_child) & 1u) != 0; };
      const auto index_of = [&](std::uint32_t i) { return node.first + (i ^ nearest_child); };
      const auto range_of = [&](std::uint32_t i) {
        return naive ? slab_test(slab_ray, octree.nodes[index_of(i)].box, limit) : slabs(i);
      };
      if (recorder.collects())
        for (std::uint32_t i = 0; i < 8; ++i)
          if (is_filled(i)) report(index_of(i), level + 1, range_of(i).hit());
      const unsigned candidates = naive ? 0xffu : slabs.candidates();
      for (std::uint32_t i = 8; i-- > 0;) {  // the nearest on top
        if ((candidates >> i & 1u) == 0 || !is_filled(i)) continue;
        const SlabRange<Real> range = range_of(i);
        waiting[top] = index_of(i);
        levels[top] = level + 1;
        nears[top] = range.near;
        top += range.hit() ? 1 : 0;
      }
    }
    do {
      if (top == 0) return;
      --top;
    } while (nears[top] > limit);
    current = waiting[top];
    level = levels[top];
  }
}

}  // namespace ps
