#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "accel/candidate_ray.h"
#include "base/memory_size.h"
#include "inspect/recorder.h"

namespace ps {

/// A cell. A leaf (`leaf`) lists `count` entries of Octree::entries from `first`; others have the children `first` ..
/// `first + 7`, child i above the middle on the axes whose bit is set in i.
template <class Real>
struct OctreeNode {
  Box<Real> box;
  std::uint32_t first = 0;
  std::uint32_t count = 0;
  bool leaf = true;
};

/// Space cut into eight equal parts, again and again. A primitive stands in every leaf that it touches, so it may be
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
/// it.
template <class Real>
Octree<Real> build_octree(const Box<Real>& box, std::uint32_t primitives, const OctreeOptions& options,
                          const std::function<bool(std::uint32_t, const Box<Real>&)>& overlaps);

/// The accelerator interface (accel/none.h). Cells are entered from near to far. A hit may lie behind the cell that
/// found it; it ends the search only for cells that begin behind the hit.
template <class Real, class Visit, class Recorder>
void for_each_candidate(const Octree<Real>& octree, const CandidateRay<Real>& ray, const Real& limit, Visit&& visit,
                        Recorder& recorder) {
  struct Waiting {
    std::uint32_t node;
    int level;
    Real near;
  };
  std::array<Waiting, 7 * octree_max_depth + 8> stack;
  std::size_t waiting = 0;
  const auto meet = [&](std::uint32_t index, int level) {
    const OctreeNode<Real>& node = octree.nodes[index];
    if (node.leaf && node.count == 0) return;
    const SlabRange<Real> range = slab_test(ray.slabs, node.box, limit);
    recorder.event([&] {
      return NodeEvent{static_cast<int>(index), level, Vec3d(node.box.low), Vec3d(node.box.high), range.hit()};
    });
    if (range.hit()) stack[waiting++] = {index, level, range.near};
  };
  if (!octree.nodes.empty()) meet(0, 0);
  while (waiting > 0) {
    const Waiting current = stack[--waiting];
    if (current.near > limit) continue;
    recorder.count(Counter::node_visits);
    const OctreeNode<Real>& node = octree.nodes[current.node];
    if (node.leaf) {
      for (std::uint32_t i = 0; i < node.count; ++i)
        if (visit(octree.entries[node.first + i])) return;
      continue;
    }
    const std::size_t before = waiting;
    for (std::uint32_t child = 0; child < 8; ++child) meet(node.first + child, current.level + 1);
    for (std::size_t i = before + 1; i < waiting; ++i)  // the nearest on top
      for (std::size_t k = i; k > before && stack[k - 1].near < stack[k].near; --k) std::swap(stack[k - 1], stack[k]);
  }
}

}  // namespace ps
