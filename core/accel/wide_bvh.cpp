#include "accel/wide_bvh.h"

#include <algorithm>
#include <array>
#include <limits>

#include "base/parallel.h"

namespace ps {
namespace {

constexpr std::uint32_t nobody = 0xffffffffu;

WideNode empty_node() {
  WideNode node;
  for (int plane = 0; plane < 6; ++plane)
    for (int slot = 0; slot < wide_width; ++slot)
      node.planes[plane][slot] =
          plane % 2 == 0 ? std::numeric_limits<float>::infinity() : -std::numeric_limits<float>::infinity();
  std::fill(std::begin(node.child), std::end(node.child), 0u);
  std::fill(std::begin(node.order), std::end(node.order), 0u);
  return node;
}

/// Fills `order` from the centres of the boxes.
void order_children(WideNode& node, std::size_t count) {
  for (unsigned octant = 0; octant < 8; ++octant) {
    std::array<float, wide_width> distance{};  // along the octant's diagonal
    std::array<std::uint32_t, wide_width> slots{0, 1, 2, 3, 4, 5, 6, 7};
    for (std::size_t slot = 0; slot < count; ++slot)
      for (unsigned axis = 0; axis < 3; ++axis) {
        const float centre = node.planes[2 * axis][slot] + node.planes[2 * axis + 1][slot];
        distance[slot] += (octant >> axis & 1u) != 0 ? -centre : centre;
      }
    for (std::size_t i = 1; i < count; ++i)
      for (std::size_t k = i; k > 0 && distance[slots[k - 1]] > distance[slots[k]]; --k)
        std::swap(slots[k - 1], slots[k]);
    for (std::size_t place = 0; place < wide_width; ++place) node.order[place] |= slots[place] << (3 * octant);
  }
}

class Widener {
 public:
  Widener(const Bvh<float>& bvh, std::vector<BlockRange>& blocks) : bvh_(bvh), blocks_(blocks) {}

  LargeArray<WideNode> run() {
    nodes_.push_back(empty_node());
    if (bvh_.nodes.empty()) return std::move(nodes_);
    if (bvh_.nodes[0].count > 0)
      fill(0, std::array{bvh_.nodes[0]});
    else
      fill(0, std::array{bvh_.nodes[bvh_.nodes[0].first], bvh_.nodes[bvh_.nodes[0].first + 1]});
    return std::move(nodes_);
  }

 private:
  static constexpr std::uint32_t leaf_size = wide_leaf_blocks * wide_block_width;

  static bool opens(const BvhNode<float>& node) { return node.count == 0 || node.count > leaf_size; }

  /// The children of a node. A leaf that has too many primitives for one child is cut in the middle of its list.
  std::array<BvhNode<float>, 2> parts(const BvhNode<float>& node) const {
    if (node.count == 0) return {bvh_.nodes[node.first], bvh_.nodes[node.first + 1]};
    const std::uint32_t half = (node.count / 2 + leaf_size - 1) / leaf_size * leaf_size;
    return {BvhNode<float>{node.box, node.first, half}, BvhNode<float>{node.box, node.first + half, node.count - half}};
  }

  void fill(std::uint32_t index, std::span<const BvhNode<float>> start) {
    std::array<BvhNode<float>, wide_width> open;
    std::copy(start.begin(), start.end(), open.begin());
    std::size_t count = start.size();
    while (count < wide_width) {
      std::size_t largest = count;
      float area = -1;
      for (std::size_t i = 0; i < count; ++i) {
        if (!opens(open[i]) || !(open[i].box.half_area() > area)) continue;
        area = open[i].box.half_area();
        largest = i;
      }
      if (largest == count) break;  // leaves only
      const std::array<BvhNode<float>, 2> children = parts(open[largest]);
      open[largest] = children[0];
      open[count++] = children[1];
    }
    for (std::size_t i = 0; i < count; ++i) put_box(index, i, open[i].box);
    order_children(nodes_[index], count);
    for (std::size_t i = 0; i < count; ++i) {
      if (!opens(open[i])) {
        nodes_[index].child[i] = add_leaf(open[i]);
        continue;
      }
      const auto place = static_cast<std::uint32_t>(nodes_.size());
      nodes_[index].child[i] = place;
      nodes_.push_back(empty_node());
      fill(place, parts(open[i]));
    }
  }

  void put_box(std::uint32_t index, std::size_t slot, const Box<float>& box) {
    for (int axis = 0; axis < 3; ++axis) {
      nodes_[index].planes[2 * axis][slot] = box.low[axis];
      nodes_[index].planes[2 * axis + 1][slot] = box.high[axis];
    }
  }

  WideChild add_leaf(const BvhNode<float>& leaf) {
    const auto place = static_cast<std::uint32_t>(blocks_.size());
    for (std::uint32_t first = 0; first < leaf.count; first += wide_block_width)
      blocks_.push_back({leaf.first + first, std::min<std::uint32_t>(wide_block_width, leaf.count - first)});
    return wide_leaf(place, static_cast<std::uint32_t>(blocks_.size()) - place);
  }

  const Bvh<float>& bvh_;
  std::vector<BlockRange>& blocks_;
  LargeArray<WideNode> nodes_;
};

}  // namespace

LargeArray<WideNode> widen_nodes(const Bvh<float>& bvh, std::vector<BlockRange>& blocks) {
  return Widener(bvh, blocks).run();
}

void clear_block(TriangleBlock& block) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  for (auto& corner : block.corner)
    for (auto& axis : corner) std::fill(std::begin(axis), std::end(axis), nan);
  std::fill(std::begin(block.primitive), std::end(block.primitive), nobody);
}

void put_triangle(TriangleBlock& block, std::size_t lane, const WideTriangle& triangle) {
  const std::array<Vec3f, 3> corners{triangle.a, triangle.b, triangle.c};
  for (std::size_t corner = 0; corner < 3; ++corner)
    for (int axis = 0; axis < 3; ++axis) block.corner[corner][axis][lane] = corners[corner][axis];
  block.primitive[lane] = triangle.primitive;
}

void for_each_range(std::size_t count, int threads, const std::function<void(std::size_t, std::size_t)>& body) {
  constexpr std::size_t step = 1u << 13;
  Progress progress;
  parallel_for(static_cast<int>((count + step - 1) / step), {threads, WorkerPriority::normal}, progress,
               [&](int index, int) {
                 const std::size_t begin = static_cast<std::size_t>(index) * step;
                 body(begin, std::min(count, begin + step));
               });
}

}  // namespace ps
