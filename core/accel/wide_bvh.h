#pragma once
#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "accel/bvh.h"
#include "base/large_array.h"

namespace ps {

inline constexpr int wide_width = 8;   ///< children of a node
inline constexpr int block_width = 8;  ///< triangles of a block

/// A child of a node: another node, or a leaf of one to `wide_leaf_blocks` blocks. Of a node its index.
using WideChild = std::uint32_t;
inline constexpr std::uint32_t wide_leaf_blocks = 4;
inline constexpr WideChild wide_leaf_flag = 0x80000000u;
inline constexpr int wide_count_shift = 29;  ///< two bits: the leaf's blocks less one
/// As many triangles as one leaf holds.
inline constexpr std::uint32_t wide_leaf_size = wide_leaf_blocks * block_width;
inline bool is_leaf(WideChild child) { return (child & wide_leaf_flag) != 0; }
inline std::uint32_t leaf_first(WideChild child) { return child & ((1u << wide_count_shift) - 1); }
inline std::uint32_t leaf_count(WideChild child) { return ((child >> wide_count_shift) & 3u) + 1; }
inline WideChild wide_leaf(std::uint32_t first, std::uint32_t count) {
  return wide_leaf_flag | ((count - 1) << wide_count_shift) | first;
}

/// Block 0 of every tree has no triangles. Places without a child lead there: a ray of hostile numbers may enter
/// them, finds nothing, and goes no deeper.
inline constexpr std::uint32_t wide_empty_block = 0;

/// Up to eight children whose boxes are tested by the same instructions. Places without a child hold an empty box.
struct alignas(64) WideNode {
  /// Planes of the children's boxes: low x, high x, low y, high y, low z, high z.
  float planes[6][wide_width];
  WideChild child[wide_width];
  /// For each octant of ray directions the slots of the children in the order from near to far: that of place p in
  /// three bits from bit 3 p on. Bit k of an octant says that the direction points down axis k.
  std::uint32_t order[8];
};

/// The slot at a place of an order.
inline std::uint32_t slot_at(std::uint32_t order, std::size_t place) { return order >> (3 * place) & 7u; }

/// A node without children, and how one is filled: a box for each place, then, once all are there, the orders.
WideNode empty_wide_node();
void put_box(WideNode& node, std::size_t slot, const Box<float>& box);
void order_children(WideNode& node, std::size_t count);

/// A triangle's vertices, and its index among all primitives.
struct WideTriangle {
  Vec3f a, b, c;
  std::uint32_t primitive = 0;
};

/// Vertices of triangles side by side. Places without a triangle hold NaN, which no test accepts.
struct alignas(64) TriangleBlock {
  float corner[3][3][block_width];  ///< [corner a b c][axis][lane]
  std::uint32_t primitive[block_width];

  void clear() {
    for (auto& axes : corner)
      for (auto& axis : axes) std::fill(std::begin(axis), std::end(axis), std::numeric_limits<float>::quiet_NaN());
    std::fill(std::begin(primitive), std::end(primitive), 0xffffffffu);
  }
  void put(std::size_t lane, const WideTriangle& triangle) {
    for (int axis = 0; axis < 3; ++axis) {
      corner[0][axis][lane] = triangle.a[axis];
      corner[1][axis][lane] = triangle.b[axis];
      corner[2][axis][lane] = triangle.c[axis];
    }
    primitive[lane] = triangle.primitive;
  }
};

/// Triangles without a tree: for a search that tests them all.
struct TriangleList {
  LargeArray<TriangleBlock> blocks;

  std::size_t heap_bytes() const { return owned_bytes(blocks); }
};

/// A tree eight wide over triangles, for queries of single rays with SIMD. Node 0 is the root.
struct WideBvh {
  LargeArray<WideNode> nodes;
  LargeArray<TriangleBlock> blocks;
  Vec3f centre{0};  ///< the planes of the nodes are as seen from here (see_from())
  /// More entries can never wait while one ray is followed; a leaf too large for one child makes a node more.
  static constexpr int most_waiting = (bvh_max_depth + 32) * (wide_width - 1) + 1;

  std::size_t heap_bytes() const { return owned_bytes(nodes, blocks); }
};

/// Turns a tree of two-wide nodes over `triangles` into one of eight-wide nodes, of all those that can be made by
/// leaving out nodes and joining leaves the one that costs least by the surface-area heuristic. `triangle(i)` is called
/// for the entries of bvh.order, from several threads.
template <class TriangleOf>
WideBvh widen(const Bvh<float>& bvh, TriangleOf&& triangle, int threads = 0);

/// Has the nodes' planes as they are seen from `centre`. Far from the world's origin floats are far apart, and what a
/// search adds up from planes and ray would be too: from a point in the middle of the tree both are small numbers.
/// Each plane is rounded once.
void see_from(const Vec3f& centre, LargeArray<WideNode>& nodes);

/// The two steps of widen(): nodes alone, with the range of bvh.order that each block takes, then the vertices.
struct BlockRange {
  std::uint32_t first = 0, count = 0;
};
LargeArray<WideNode> widen_nodes(const Bvh<float>& bvh, std::vector<BlockRange>& blocks, int threads);
void for_each_range(std::size_t count, int threads, const std::function<void(std::size_t, std::size_t)>& body);

template <class TriangleOf>
WideBvh widen(const Bvh<float>& bvh, TriangleOf&& triangle, int threads) {
  WideBvh wide;
  std::vector<BlockRange> ranges;
  wide.nodes = widen_nodes(bvh, ranges, threads);
  wide.blocks.resize(ranges.size());
  for_each_range(ranges.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      wide.blocks[i].clear();
      for (std::uint32_t k = 0; k < ranges[i].count; ++k)
        wide.blocks[i].put(k, triangle(bvh.order[ranges[i].first + k]));
    }
  });
  return wide;
}

}  // namespace ps
