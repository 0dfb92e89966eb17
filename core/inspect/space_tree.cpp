#include "inspect/space_tree.h"

#include <algorithm>
#include <set>
#include <vector>

#include "base/overloaded.h"
#include "inspect/space_parts.h"
#include "options/renderer_kind.h"
#include "raytrace/base/accelerators.h"
#include "render/story/story_tree.h"

namespace ps {
namespace {

/// One node of any of the trees.
struct DrawnNode {
  int number = 0, level = 0;
  Vec3d low{0, 0, 0}, high{0, 0, 0};
  double radius = 0;  ///< above 0: a sphere
};

/// Calls visit(node, level) for the root and what lies below, level by level; children(node) are the numbers of a
/// node's children.
template <class Children, class Visit>
void by_level(std::size_t nodes, Children&& children, Visit&& visit) {
  std::vector<std::uint32_t> level_nodes, below;
  if (nodes > 0) level_nodes.push_back(0);
  for (int level = 0; !level_nodes.empty(); ++level) {
    below.clear();
    for (const std::uint32_t node : level_nodes) {
      visit(node, level);
      children(node, below);
    }
    level_nodes.swap(below);
  }
}

/// The first nodes of a tree, level by level, and the counts of all.
class TreeNodes {
 public:
  explicit TreeNodes(std::size_t most) : most_(most) {}
  std::vector<DrawnNode> list;
  SpaceTree counts;

  template <class Real>
  void add(const Octree<Real>& octree) {
    const auto children = [&](std::uint32_t i, std::vector<std::uint32_t>& below) {
      const OctreeNode<Real>& node = octree.nodes[i];
      for (std::uint32_t k = 0; k < 8 && !node.leaf; ++k)
        if ((node.filled >> k & 1u) != 0) below.push_back(node.first + k);
    };
    by_level(octree.nodes.size(), children, [&](std::uint32_t i, int level) { box(i, level, octree.nodes[i].box); });
    counts.entries += octree.entries.size();
  }
  template <class Real>
  void add(const Bvh<Real>& bvh) {
    const auto children = [&](std::uint32_t i, std::vector<std::uint32_t>& below) {
      if (bvh.nodes[i].count == 0) below.insert(below.end(), {bvh.nodes[i].first, bvh.nodes[i].first + 1});
    };
    by_level(bvh.nodes.size(), children, [&](std::uint32_t i, int level) { box(i, level, bvh.nodes[i].box); });
    counts.entries += bvh.order.size();
  }
  void add(const BoundingSpheres& spheres) {
    const auto children = [&](std::uint32_t i, std::vector<std::uint32_t>& below) {
      const SphereNode& node = spheres.nodes[i];
      if (node.count == 0) below.insert(below.end(), {node.first, node.first + 1});
    };
    by_level(spheres.nodes.size(), children, [&](std::uint32_t i, int level) {
      const SphereNode& node = spheres.nodes[i];
      add_node({static_cast<int>(i), level, node.centre - node.radius, node.centre + node.radius, node.radius});
    });
    counts.entries += spheres.order.size();
  }
  template <class Real>
  void add(const TwoLevel<Real>& trees, const TracedGeometry<Real>& geometry) {
    add(trees.top);
    for (std::size_t i = 0; i < geometry.instances.size(); ++i)
      add_node({static_cast<int>(trees.top.nodes.size() + i), trees.top_levels, geometry.instances[i].box.low,
                geometry.instances[i].box.high, 0});
  }
  template <class Real>
  void add(const SingleBox<Real>& all) {
    if (all.primitives.empty()) return;
    box(0, 0, all.box);
    counts.entries += all.primitives.size();
  }

 private:
  template <class Real>
  void box(std::uint32_t number, int level, const Box<Real>& around) {
    add_node({static_cast<int>(number), level, Vec3d(around.low), Vec3d(around.high), 0});
  }
  void add_node(const DrawnNode& node) {
    ++counts.nodes;
    if (list.size() < most_) list.push_back(node);
  }
  std::size_t most_;
};

template <class Real>
TreeNodes nodes_of_tree(const Scene& scene, const Settings& settings, Prepared& prepared, std::size_t most) {
  TreeNodes nodes(most);
  const auto geometry = traced_geometry<Real>(scene, settings, prepared);
  nodes.counts.primitives = bounded_count(*geometry);
  std::visit(Overloaded{[](const NoAccelerator&) {}, [](const std::shared_ptr<const EmbreeGeometry<Real>>&) {},
                        [&](const std::shared_ptr<const TwoLevel<Real>>& trees) { nodes.add(*trees, *geometry); },
                        [&](const std::shared_ptr<const BvhOnDemand<Real>>& bvh) { nodes.add(bvh->tree()); },
                        [&](const auto& tree) { nodes.add(*tree); }},
             traced_accelerator<Real>(scene, geometry, settings, prepared));
  return nodes;
}

}  // namespace

SpaceTree add_tree(const Scene& scene, const Settings& settings, const PixelStory* story, Prepared& prepared,
                   SpaceModel& model, std::size_t most) {
  if (!sends_rays(settings.renderer)) return {};
  const TreeNodes nodes = settings.precision == Precision::float64
                              ? nodes_of_tree<double>(scene, settings, prepared, most)
                              : nodes_of_tree<float>(scene, settings, prepared, most);
  std::set<int> asked;
  if (story)
    for (const auto* node : events_of<NodeEvent>(story->events))
      if (node->object < 0) asked.insert(node->node);
  std::size_t drawn = asked.size();
  for (const DrawnNode& node : nodes.list) {
    if (drawn >= most) break;
    if (asked.count(node.number) != 0) continue;
    ++drawn;
    SpaceItem item;
    item.kind = SpaceKind::node;
    item.shape = node.radius > 0 ? SpaceShape::line : SpaceShape::box;
    item.points = node.radius > 0 ? sphere_outline((node.low + node.high) * 0.5, node.radius)
                                  : std::vector<Vec3d>{node.low, node.high};
    item.level = node.level;
    item.emphasised = false;
    model.deepest_level = std::max(model.deepest_level, item.level);
    model.items.push_back(std::move(item));
  }
  return nodes.counts;
}

}  // namespace ps
