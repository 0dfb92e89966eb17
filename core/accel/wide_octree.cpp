#include "accel/wide_octree.h"

#include <algorithm>
#include <array>
#include <span>

#include "base/stop.h"

namespace ps {
namespace {

class OctreeWidener {
 public:
  OctreeWidener(const Octree<float>& octree, const TriangleOfEntry& triangle) : octree_(octree), triangle_(triangle) {}

  WideBvh widen() {
    reserve_blocks();
    wide_.blocks.emplace_back().clear();       // wide_empty_block
    wide_.nodes.push_back(empty_wide_node());  // the root, once it is known
    const std::optional<Filled> root = octree_.nodes.empty() ? std::nullopt : add(0);
    if (!root) return std::move(wide_);
    if (is_leaf(root->child)) {
      fill(wide_.nodes[0], std::span(&*root, 1));
    } else {
      wide_.nodes[0] = wide_.nodes.back();
      wide_.nodes.pop_back();
    }
    return std::move(wide_);
  }

 private:
  /// Growing the array would need it twice.
  void reserve_blocks() {
    std::size_t blocks = 1;
    for (const OctreeNode<float>& cell : octree_.nodes)
      if (cell.leaf) blocks += (cell.count + block_width - 1) / block_width;
    wide_.blocks.reserve(blocks + blocks / 16);
  }

  /// A subtree in which triangles lie, and a box around them, no larger than their cell.
  struct Filled {
    WideChild child = 0;
    Box<float> box;
  };

  std::optional<Filled> add(std::uint32_t index) {
    check_stop();
    const OctreeNode<float>& cell = octree_.nodes[index];
    if (cell.leaf) {
      std::vector<WideTriangle> triangles;
      for (std::uint32_t i = 0; i < cell.count; ++i)
        if (const auto triangle = triangle_(octree_.entries[cell.first + i])) triangles.push_back(*triangle);
      return add_triangles(triangles, cell.box);
    }
    std::vector<Filled> children;
    for (std::uint32_t i = 0; i < 8; ++i)
      if ((cell.filled >> i & 1u) != 0)
        if (const auto child = add(cell.first + i)) children.push_back(*child);
    return join(children);
  }

  /// A leaf, or, for more triangles than one can hold, a node of such.
  std::optional<Filled> add_triangles(std::span<const WideTriangle> triangles, const Box<float>& cell) {
    if (triangles.size() <= wide_leaf_size) return add_leaf(triangles, cell);
    std::vector<Filled> children;
    const std::size_t share = (triangles.size() + wide_width - 1) / wide_width;
    for (; !triangles.empty(); triangles = triangles.subspan(std::min(share, triangles.size())))
      if (const auto child = add_triangles(triangles.first(std::min(share, triangles.size())), cell))
        children.push_back(*child);
    return join(children);
  }

  std::optional<Filled> add_leaf(std::span<const WideTriangle> triangles, const Box<float>& cell) {
    if (triangles.empty()) return {};
    Box<float> box;
    const auto first = static_cast<std::uint32_t>(wide_.blocks.size());
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      const std::size_t lane = i % block_width;
      if (lane == 0) wide_.blocks.emplace_back().clear();
      wide_.blocks.back().put(lane, triangles[i]);
      for (const Vec3f& corner : {triangles[i].a, triangles[i].b, triangles[i].c}) box.include(corner);
    }
    for (int axis = 0; axis < 3; ++axis) {
      box.low[axis] = std::clamp(box.low[axis], cell.low[axis], cell.high[axis]);
      box.high[axis] = std::clamp(box.high[axis], cell.low[axis], cell.high[axis]);
    }
    return Filled{wide_leaf(first, static_cast<std::uint32_t>(wide_.blocks.size()) - first), box};
  }

  std::optional<Filled> join(std::span<const Filled> children) {
    if (children.empty()) return {};
    if (children.size() == 1) return children[0];
    Filled joined;
    for (const Filled& child : children) {
      joined.box.include(child.box.low);
      joined.box.include(child.box.high);
    }
    joined.child = static_cast<WideChild>(wide_.nodes.size());
    fill(wide_.nodes.emplace_back(empty_wide_node()), children);
    return joined;
  }

  static void fill(WideNode& node, std::span<const Filled> children) {
    for (std::size_t i = 0; i < children.size(); ++i) {
      put_box(node, i, children[i].box);
      node.child[i] = children[i].child;
    }
    order_children(node, children.size());
  }

  const Octree<float>& octree_;
  const TriangleOfEntry& triangle_;
  WideBvh wide_;
};

}  // namespace

WideBvh widen_octree(const Octree<float>& octree, const TriangleOfEntry& triangle) {
  return OctreeWidener(octree, triangle).widen();
}

}  // namespace ps
