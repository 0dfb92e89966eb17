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
  std::fill(std::begin(node.blocks), std::end(node.blocks), 0u);
  return node;
}

class Widener {
 public:
  Widener(const Bvh<float>& bvh, std::vector<BlockRange>& blocks) : bvh_(bvh), blocks_(blocks) {}

  std::vector<WideNode> run() {
    nodes_.push_back(empty_node());
    if (bvh_.nodes.empty()) return std::move(nodes_);
    if (bvh_.nodes[0].count > 0)
      put_leaf(0, 0, bvh_.nodes[0]);
    else
      fill(0, bvh_.nodes[0]);
    return std::move(nodes_);
  }

 private:
  void fill(std::uint32_t index, const BvhNode<float>& node) {
    std::array<std::uint32_t, wide_width> open{node.first, node.first + 1};
    std::size_t count = 2;
    while (count < wide_width) {
      std::size_t largest = count;
      float area = -1;
      for (std::size_t i = 0; i < count; ++i) {
        const BvhNode<float>& candidate = bvh_.nodes[open[i]];
        if (candidate.count > 0 || !(candidate.box.half_area() > area)) continue;
        area = candidate.box.half_area();
        largest = i;
      }
      if (largest == count) break;  // leaves only
      const std::uint32_t children = bvh_.nodes[open[largest]].first;
      open[largest] = children;
      open[count++] = children + 1;
    }
    for (std::size_t i = 0; i < count; ++i) {
      const BvhNode<float>& child = bvh_.nodes[open[i]];
      if (child.count > 0) {
        put_leaf(index, i, child);
        continue;
      }
      const auto place = static_cast<std::uint32_t>(nodes_.size());
      put_box(index, i, child.box);
      nodes_[index].child[i] = place;
      nodes_.push_back(empty_node());
      fill(place, child);
    }
  }

  void put_box(std::uint32_t index, std::size_t slot, const Box<float>& box) {
    for (int axis = 0; axis < 3; ++axis) {
      nodes_[index].planes[2 * axis][slot] = box.low[axis];
      nodes_[index].planes[2 * axis + 1][slot] = box.high[axis];
    }
  }

  void put_leaf(std::uint32_t index, std::size_t slot, const BvhNode<float>& leaf) {
    put_box(index, slot, leaf.box);
    nodes_[index].child[slot] = static_cast<std::uint32_t>(blocks_.size());
    nodes_[index].blocks[slot] = (leaf.count + wide_block_width - 1) / wide_block_width;
    for (std::uint32_t first = 0; first < leaf.count; first += wide_block_width)
      blocks_.push_back({leaf.first + first, std::min<std::uint32_t>(wide_block_width, leaf.count - first)});
  }

  const Bvh<float>& bvh_;
  std::vector<BlockRange>& blocks_;
  std::vector<WideNode> nodes_;
};

}  // namespace

std::vector<WideNode> widen_nodes(const Bvh<float>& bvh, std::vector<BlockRange>& blocks) {
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
