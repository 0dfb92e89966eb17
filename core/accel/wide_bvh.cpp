#include "accel/wide_bvh.h"

#include <algorithm>
#include <array>
#include <limits>

#include "base/parallel.h"

namespace ps {
WideNode empty_wide_node() {
  WideNode node;
  for (int plane = 0; plane < 6; ++plane)
    for (int slot = 0; slot < wide_width; ++slot)
      node.planes[plane][slot] =
          plane % 2 == 0 ? std::numeric_limits<float>::infinity() : -std::numeric_limits<float>::infinity();
  std::fill(std::begin(node.child), std::end(node.child), 0u);
  std::fill(std::begin(node.order), std::end(node.order), 0u);
  return node;
}

void put_box(WideNode& node, std::size_t slot, const Box<float>& box) {
  for (int axis = 0; axis < 3; ++axis) {
    node.planes[2 * axis][slot] = box.low[axis];
    node.planes[2 * axis + 1][slot] = box.high[axis];
  }
}

// From the centres of the boxes.
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

namespace {

/// Nodes of a subtree, which refer to each other and to `blocks` as if nothing came before them.
struct WidePart {
  std::vector<WideNode> nodes;
  std::vector<BlockRange> blocks;
};

/// A child that somebody else is to fill: place `slot` of node `node`.
struct OpenChild {
  std::uint32_t node = 0;
  std::size_t slot = 0;
  BvhNode<float> tree;
};

/// Turns the tree below a node into a WidePart; children deeper than `levels` are left open.
class Widener {
 public:
  Widener(const Bvh<float>& bvh, int levels) : bvh_(bvh), levels_(levels) {}

  void run(const BvhNode<float>& root) {
    part.nodes.push_back(empty_wide_node());
    if (opens(root))
      fill(0, parts(root), 0);
    else
      fill(0, std::array{root}, 0);
  }

  WidePart part;
  std::vector<OpenChild> open;

 private:
  static constexpr std::uint32_t leaf_size = wide_leaf_blocks * wide_block_width;

  static bool opens(const BvhNode<float>& node) { return node.count == 0 || node.count > leaf_size; }

  /// The children of a node. A leaf that has too many primitives for one child is cut in the middle of its list.
  std::array<BvhNode<float>, 2> parts(const BvhNode<float>& node) const {
    if (node.count == 0) return {bvh_.nodes[node.first], bvh_.nodes[node.first + 1]};
    const std::uint32_t half = (node.count / 2 + leaf_size - 1) / leaf_size * leaf_size;
    return {BvhNode<float>{node.box, node.first, half}, BvhNode<float>{node.box, node.first + half, node.count - half}};
  }

  void fill(std::uint32_t index, std::span<const BvhNode<float>> start, int level) {
    std::array<BvhNode<float>, wide_width> children;
    std::copy(start.begin(), start.end(), children.begin());
    std::size_t count = start.size();
    while (count < wide_width) {
      std::size_t largest = count;
      float area = -1;
      for (std::size_t i = 0; i < count; ++i) {
        if (!opens(children[i]) || !(children[i].box.half_area() > area)) continue;
        area = children[i].box.half_area();
        largest = i;
      }
      if (largest == count) break;  // leaves only
      const std::array<BvhNode<float>, 2> halves = parts(children[largest]);
      children[largest] = halves[0];
      children[count++] = halves[1];
    }
    for (std::size_t i = 0; i < count; ++i) put_box(part.nodes[index], i, children[i].box);
    order_children(part.nodes[index], count);
    for (std::size_t i = 0; i < count; ++i) {
      if (!opens(children[i])) {
        part.nodes[index].child[i] = add_leaf(children[i]);
      } else if (level + 1 == levels_) {
        open.push_back({index, i, children[i]});
      } else {
        const auto place = static_cast<std::uint32_t>(part.nodes.size());
        part.nodes[index].child[i] = place;
        part.nodes.push_back(empty_wide_node());
        fill(place, parts(children[i]), level + 1);
      }
    }
  }

  WideChild add_leaf(const BvhNode<float>& leaf) {
    const auto place = static_cast<std::uint32_t>(part.blocks.size());
    for (std::uint32_t first = 0; first < leaf.count; first += wide_block_width)
      part.blocks.push_back({leaf.first + first, std::min<std::uint32_t>(wide_block_width, leaf.count - first)});
    return wide_leaf(place, static_cast<std::uint32_t>(part.blocks.size()) - place);
  }

  const Bvh<float>& bvh_;
  int levels_;
};

constexpr int all_levels = -1;
/// Small trees are one worker's job.
constexpr std::size_t one_job = 1u << 12;

}  // namespace

LargeArray<WideNode> widen_nodes(const Bvh<float>& bvh, std::vector<BlockRange>& blocks, int threads) {
  // The upper levels first; then every subtree below them is one worker's job, and they are put behind each other.
  Widener top(bvh, bvh.nodes.size() < one_job ? all_levels : 3);
  if (bvh.nodes.empty())
    top.part.nodes.push_back(empty_wide_node());
  else
    top.run(bvh.nodes[0]);
  std::vector<WidePart> parts(top.open.size());
  const ParallelOptions options{threads, WorkerPriority::normal};
  Progress progress;
  const auto in_parallel = [&](auto&& body) {
    parallel_for(static_cast<int>(parts.size()), options, progress,
                 [&](int index, int) { body(static_cast<std::size_t>(index)); });
  };
  in_parallel([&](std::size_t i) {
    Widener widener(bvh, all_levels);
    widener.run(top.open[i].tree);
    parts[i] = std::move(widener.part);
  });
  std::size_t nodes = top.part.nodes.size(), ranges = top.part.blocks.size();
  std::vector<std::array<std::uint32_t, 2>> shifts;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    shifts.push_back({static_cast<std::uint32_t>(nodes), static_cast<std::uint32_t>(ranges)});
    top.part.nodes[top.open[i].node].child[top.open[i].slot] = static_cast<std::uint32_t>(nodes);
    nodes += parts[i].nodes.size();
    ranges += parts[i].blocks.size();
  }
  LargeArray<WideNode> result(nodes);
  blocks.resize(ranges);
  std::copy(top.part.nodes.begin(), top.part.nodes.end(), result.begin());
  std::copy(top.part.blocks.begin(), top.part.blocks.end(), blocks.begin());
  in_parallel([&](std::size_t i) {
    const auto [node_shift, block_shift] = shifts[i];
    for (WideNode& node : parts[i].nodes)
      for (int slot = 0; slot < wide_width; ++slot)
        node.child[slot] += is_leaf(node.child[slot]) ? block_shift : node_shift;
    std::copy(parts[i].nodes.begin(), parts[i].nodes.end(), result.begin() + node_shift);
    std::copy(parts[i].blocks.begin(), parts[i].blocks.end(), blocks.begin() + block_shift);
    parts[i] = {};
  });
  return result;
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
