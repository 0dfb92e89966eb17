#include "accel/wide_bvh.h"

#include <algorithm>
#include <array>
#include <limits>

#include "accel/four_lanes.h"
#include "base/parallel.h"
#include "base/stop.h"

namespace ps {
WideNode empty_wide_node() {
  WideNode node;
  for (int plane = 0; plane < 6; ++plane)
    for (int slot = 0; slot < wide_width; ++slot)
      node.planes[plane][slot] =
          plane % 2 == 0 ? std::numeric_limits<float>::infinity() : -std::numeric_limits<float>::infinity();
  std::fill(std::begin(node.child), std::end(node.child), wide_leaf(wide_empty_block, 1));
  std::fill(std::begin(node.order), std::end(node.order), 0u);
  return node;
}

void put_box(WideNode& node, std::size_t slot, const Box<float>& box) {
  for (int axis = 0; axis < 3; ++axis) {
    node.planes[2 * axis][slot] = box.low[axis];
    node.planes[2 * axis + 1][slot] = box.high[axis];
  }
}

// From the centres of the boxes, for all octants side by side: a child's place is the number of those before it.
void order_children(WideNode& node, std::size_t count) {
  using Lanes = FourLanes<float>;
  struct Octants {                        // of one child: four that look up z, four that look down
    std::array<Lanes::Type, 2> distance;  // along the octant's diagonal
    std::array<Lanes::Index, 2> place{};
  };
  std::array<Octants, wide_width> children;
  for (std::size_t slot = 0; slot < wide_width; ++slot) {
    constexpr Lanes::Type far = Lanes::Type{} + std::numeric_limits<float>::infinity();
    const auto centre = [&](int axis) { return node.planes[2 * axis][slot] + node.planes[2 * axis + 1][slot]; };
    const float x = centre(0), y = centre(1), z = centre(2);
    const Lanes::Type along = Lanes::Type{x, -x, x, -x} + Lanes::Type{y, y, -y, -y};
    Octants& child = children[slot];
    child.distance = {along + z, along - z};
    for (Lanes::Type& value : child.distance)  // where sums overflow; every child needs a place of its own
      value = slot >= count ? far : value == value ? value : Lanes::Type{};
    for (std::size_t other = 0; other < slot; ++other)
#pragma GCC unroll 2
      for (std::size_t half = 0; half < 2; ++half) {  // a comparison that holds is -1
        const Lanes::Index other_first = children[other].distance[half] <= child.distance[half];
        child.place[half] -= other_first;
        children[other].place[half] += 1 + other_first;
      }
  }
  for (std::uint32_t slot = 0; slot < wide_width; ++slot)
    for (int octant = 0; octant < 8; ++octant)
      node.order[octant] |= slot << (3 * children[slot].place[static_cast<std::size_t>(octant / 4)][octant % 4]);
}

namespace {

/// Cost of testing a block of triangles, in tests of a node.
constexpr float block_cost = 0.8f;

/// How a subtree of the two-wide tree is best opened into a wide one, by the surface-area heuristic: its least cost as
/// one to seven children of a node above it (Ylitie, Karras and Laine 2017, 3.1).
struct WideCost {
  std::array<float, wide_width - 1> as_children;
  std::uint32_t first = 0, count = 0;  ///< its primitives in Bvh::order
  bool leaf = false;                   ///< as one child it is a leaf
};

/// The least cost of two subtrees as `children` children together, and how many of them are the left one's.
float least_shared(const WideCost& left, const WideCost& right, std::size_t children, std::size_t& of_left) {
  float least = std::numeric_limits<float>::infinity();
  of_left = 1;
  for (std::size_t k = 1; k < children; ++k) {
    const float cost = left.as_children[k - 1] + right.as_children[children - k - 1];
    if (!(cost < least)) continue;
    least = cost;
    of_left = k;
  }
  return least;
}

std::vector<WideCost> wide_costs(const Bvh<float>& bvh) {
  std::vector<WideCost> costs(bvh.nodes.size());
  for (std::size_t i = costs.size(); i-- > 0;) {  // children are behind their parents
    const BvhNode<float>& node = bvh.nodes[i];
    const float area = node.box.half_area();
    WideCost& cost = costs[i];
    const auto as_leaf = [&] {
      const auto blocks = (cost.count + block_width - 1) / block_width;  // in whole numbers: a started block counts
      return area * block_cost * static_cast<float>(blocks);
    };
    if (node.count > 0) {
      cost.first = node.first;
      cost.count = node.count;
      cost.leaf = true;
      cost.as_children.fill(as_leaf());
      continue;
    }
    const WideCost &left = costs[node.first], &right = costs[node.first + 1];
    cost.first = left.first;
    cost.count = left.count + right.count;
    std::size_t of_left = 0;
    const float as_node = area + least_shared(left, right, wide_width, of_left);
    cost.leaf = cost.count <= wide_leaf_size && as_leaf() <= as_node;
    cost.as_children[0] = cost.leaf ? as_leaf() : as_node;
    for (std::size_t k = 2; k < wide_width; ++k)
      cost.as_children[k - 1] = std::min(cost.as_children[k - 2], least_shared(left, right, k, of_left));
  }
  return costs;
}

/// Nodes of a subtree, which refer to each other and to `blocks` as if they were the first.
struct WidePart {
  std::vector<WideNode> nodes;
  std::vector<BlockRange> blocks{BlockRange{}};  ///< the first is empty: wide_empty_block
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
  Widener(const Bvh<float>& bvh, const std::vector<WideCost>& costs, int levels)
      : bvh_(bvh), costs_(costs), levels_(levels) {}

  void run(const BvhNode<float>& root) {
    part.nodes.push_back(empty_wide_node());
    Children children;
    if (opens(root))
      add_children(root, children);
    else
      children.add(root);
    fill(0, children, 0);
  }

  WidePart part;
  std::vector<OpenChild> open;

 private:
  struct Children {
    std::array<BvhNode<float>, wide_width> list;
    std::size_t count = 0;
    void add(const BvhNode<float>& node) { list[count++] = node; }
  };

  static bool opens(const BvhNode<float>& node) { return node.count == 0 || node.count > wide_leaf_size; }

  /// The children of a node in the wide tree. A leaf that has too many primitives for one child is cut in the middle of
  /// its list, again and again.
  void add_children(const BvhNode<float>& node, Children& children) const {
    if (node.count == 0) return add_shared(node, wide_width, children);
    children.add(node);
    while (children.count < wide_width) {
      const auto end = children.list.begin() + static_cast<std::ptrdiff_t>(children.count);
      const auto largest =
          std::max_element(children.list.begin(), end, [](const auto& a, const auto& b) { return a.count < b.count; });
      if (largest->count <= wide_leaf_size) return;
      const std::uint32_t half = (largest->count / 2 + wide_leaf_size - 1) / wide_leaf_size * wide_leaf_size;
      children.add({node.box, largest->first + half, largest->count - half});
      largest->count = half;
    }
  }
  /// The two sides of an inner node as `places` children together.
  void add_shared(const BvhNode<float>& node, std::size_t places, Children& children) const {
    std::size_t of_left = 0;
    least_shared(costs_[node.first], costs_[node.first + 1], places, of_left);
    add_subtree(node.first, of_left, children);
    add_subtree(node.first + 1, places - of_left, children);
  }
  /// A subtree as at most `places` children.
  void add_subtree(std::uint32_t index, std::size_t places, Children& children) const {
    const WideCost& cost = costs_[index];
    const BvhNode<float>& node = bvh_.nodes[index];
    while (places > 1 && !(cost.as_children[places - 1] < cost.as_children[places - 2])) --places;
    if (places > 1) return add_shared(node, places, children);
    children.add(cost.leaf ? BvhNode<float>{node.box, cost.first, cost.count} : node);
  }

  void fill(std::uint32_t index, const Children& list, int level) {
    if (index % 1024 == 0) check_stop();
    const auto& children = list.list;
    const std::size_t count = list.count;
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
        Children below;
        add_children(children[i], below);
        fill(place, below, level + 1);
      }
    }
  }

  WideChild add_leaf(const BvhNode<float>& leaf) {
    const auto place = static_cast<std::uint32_t>(part.blocks.size());
    for (std::uint32_t first = 0; first < leaf.count; first += block_width)
      part.blocks.push_back({leaf.first + first, std::min<std::uint32_t>(block_width, leaf.count - first)});
    return wide_leaf(place, static_cast<std::uint32_t>(part.blocks.size()) - place);
  }

  const Bvh<float>& bvh_;
  const std::vector<WideCost>& costs_;
  int levels_;
};

constexpr int all_levels = -1;
/// Small trees are one worker's job.
constexpr std::size_t one_job = 1u << 12;

}  // namespace

LargeArray<WideNode> widen_nodes(const Bvh<float>& bvh, std::vector<BlockRange>& blocks, int threads) {
  // The upper levels first; then every subtree below them is one worker's job, and they are put behind each other.
  const std::vector<WideCost> costs = wide_costs(bvh);
  Widener top(bvh, costs, bvh.nodes.size() < one_job ? all_levels : 3);
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
    Widener widener(bvh, costs, all_levels);
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

void see_from(const Vec3f& centre, LargeArray<WideNode>& nodes) {
  for (WideNode& node : nodes) {
    for (std::size_t plane = 0; plane < 6; ++plane)
      for (float& value : node.planes[plane]) value -= centre[static_cast<int>(plane / 2)];
    std::fill(std::begin(node.order), std::end(node.order), 0u);
    const auto* const end = std::find(std::begin(node.planes[0]), std::end(node.planes[0]),
                                      std::numeric_limits<float>::infinity());  // behind the last child
    order_children(node, static_cast<std::size_t>(end - std::begin(node.planes[0])));
  }
}

void for_each_range(std::size_t count, int threads, const std::function<void(std::size_t, std::size_t)>& body) {
  const std::size_t step = std::clamp<std::size_t>(count / 8, 1u << 9, 1u << 13);
  Progress progress;
  parallel_for(static_cast<int>((count + step - 1) / step), {threads, WorkerPriority::normal}, progress,
               [&](int index, int) {
                 const std::size_t begin = static_cast<std::size_t>(index) * step;
                 body(begin, std::min(count, begin + step));
               });
}

}  // namespace ps
