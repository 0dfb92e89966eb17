// The whole accelerator in the view from outside.
#include "inspect/space_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "raytrace/base/accelerators.h"
#include "render/render.h"
#include "scene/scene_file.h"

namespace ps::space_tree_test {
namespace {

Scene teapot_scene() {
  return parse_scene("model { name = t generator = teapot divisions = 3 } instance { model = t position = (0,-1,9) }"
                     "sphere { center = (3,0,9) radius = 1 } light { type = ambient intensity = 1 }",
                     "teapot.scene", ".");
}

struct SpaceWithTree {
  SpaceModel model;
  SpaceTree tree;
  std::size_t nodes = 0;
};

SpaceWithTree with_tree(const Settings& settings, std::size_t most, Prepared& prepared) {
  const Scene scene = teapot_scene();
  const View view{scene.camera, 40, 40};
  Progress progress;
  const PixelStory story = inspect(scene, view, settings, {20, 20}, prepared, progress);
  SpaceWithTree space{build_space(scene, view, settings, &story), {}, 0};
  space.tree = add_tree(scene, settings, &story, prepared, space.model, most);
  space.nodes = static_cast<std::size_t>(count_of(space.model, SpaceKind::node));
  return space;
}

TEST(SpaceTree, DrawsEveryNodeOnce) {
  for (const Accelerator accelerator :
       {Accelerator::bvh, Accelerator::octree, Accelerator::bounding_spheres, Accelerator::box, Accelerator::two_level})
    for (const Precision precision : {Precision::float32, Precision::float64}) {
      Settings settings{.accelerator = accelerator};
      settings.precision = precision;
      settings.octree_leaf = 4;
      Prepared prepared;
      const SpaceWithTree space = with_tree(settings, 1'000'000, prepared);
      EXPECT_GE(space.tree.nodes, 1u);
      // Boxes in the model of an instance are drawn only where a ray came to them.
      if (accelerator != Accelerator::two_level) {
        EXPECT_EQ(space.nodes, space.tree.nodes);
        EXPECT_GE(space.tree.entries, space.tree.primitives);
      }
    }
}

TEST(SpaceTree, CountsWhatAnOctreeListsTwice) {
  Settings settings{.accelerator = Accelerator::octree};
  settings.octree_leaf = 4;
  Prepared prepared;
  const SpaceWithTree space = with_tree(settings, 1'000'000, prepared);
  const Scene scene = teapot_scene();
  Prepared own;
  const auto geometry = traced_geometry<float>(scene, settings, own);
  const auto accelerator = traced_accelerator<float>(scene, geometry, settings, own);
  const auto* octree = accelerator_as<Octree<float>>(accelerator);
  std::size_t listed = 0, cells = 1;
  for (const OctreeNode<float>& node : octree->nodes) {
    if (node.leaf) listed += node.count;
    for (unsigned k = 0; k < 8 && !node.leaf; ++k) cells += node.filled >> k & 1u;
  }
  EXPECT_EQ(space.tree.entries, listed);
  EXPECT_EQ(space.tree.nodes, cells);
  EXPECT_EQ(space.tree.primitives, geometry->primitives.size());
  EXPECT_GT(space.tree.entries, space.tree.primitives);
}

/// Farthest from `centre` along each axis that the points come, to both sides.
std::array<double, 6> reach_of(const std::vector<Vec3d>& points, const Vec3d& centre) {
  std::array<double, 6> reach{};
  for (const Vec3d& point : points)
    for (int axis = 0; axis < 3; ++axis) {
      const auto side = 2 * static_cast<std::size_t>(axis);
      reach[side] = std::max(reach[side], centre[axis] - point[axis]);
      reach[side + 1] = std::max(reach[side + 1], point[axis] - centre[axis]);
    }
  return reach;
}

// Every node is a line that stays on its sphere, in the planes of three great circles, and comes to all six of its
// poles. The corners of a box lie 1.7 radii away; circles of another radius or centre, and those of another node, lie
// elsewhere.
TEST(SpaceTree, DrawsBoundingSpheresAsGreatCircles) {
  const Scene scene = teapot_scene();
  const Settings settings{.accelerator = Accelerator::bounding_spheres};
  Prepared prepared, own;
  SpaceModel model;
  add_tree(scene, settings, nullptr, prepared, model, 1'000'000);
  const auto geometry = traced_geometry<float>(scene, settings, own);
  const auto accelerator = traced_accelerator<float>(scene, geometry, settings, own);
  const auto& nodes = accelerator_as<BoundingSpheres>(accelerator)->nodes;
  ASSERT_EQ(model.items.size(), nodes.size());
  ASSERT_GT(nodes.size(), 300u);
  std::vector<std::uint32_t> in_order{0};  // level by level from the root, as they are drawn
  for (std::size_t i = 0; i < in_order.size(); ++i)
    if (const SphereNode& node = nodes[in_order[i]]; node.count == 0)
      in_order.insert(in_order.end(), {node.first, node.first + 1});
  ASSERT_EQ(in_order.size(), nodes.size());
  for (std::size_t i = 0; i < in_order.size(); ++i) {
    const auto& [centre, radius, first, count] = nodes[in_order[i]];
    const SpaceItem& item = model.items[i];
    ASSERT_EQ(item.kind, SpaceKind::node);
    ASSERT_EQ(item.shape, SpaceShape::line);
    const double slack = 1e-9 * (1 + radius);
    for (const Vec3d& point : item.points) {
      const Vec3d away = point - centre;
      ASSERT_NEAR(std::sqrt(dot(away, away)), radius, slack) << i;
      ASSERT_LT(std::min({std::abs(away.x), std::abs(away.y), std::abs(away.z)}), slack) << i;
    }
    for (const double reach : reach_of(item.points, centre)) ASSERT_NEAR(reach, radius, slack) << i;
  }
}

TEST(SpaceTree, LeavesOutTheDeepestLevelsFirst) {
  Prepared prepared;
  const Settings settings{.accelerator = Accelerator::bvh};
  const SpaceWithTree all = with_tree(settings, 1'000'000, prepared), some = with_tree(settings, 200, prepared);
  EXPECT_EQ(some.nodes, 200u);
  EXPECT_EQ(some.tree.nodes, all.tree.nodes);
  int deepest = 0;
  for (const SpaceItem& item : some.model.items)
    if (item.kind == SpaceKind::node && item.event < 0) deepest = std::max(deepest, item.level);
  for (int level = 0; level < deepest; ++level) {
    const auto on_level = [&](const SpaceItem& item) { return item.kind == SpaceKind::node && item.level == level; };
    EXPECT_EQ(std::count_if(some.model.items.begin(), some.model.items.end(), on_level),
              std::count_if(all.model.items.begin(), all.model.items.end(), on_level))
        << level;
  }
}

TEST(SpaceTree, IsEmptyWithoutRays) {
  Settings settings{.renderer = Renderer::rasterizer};
  Prepared prepared;
  EXPECT_EQ(with_tree(settings, 1000, prepared).nodes, 0u);
  EXPECT_EQ(with_tree(Settings{.accelerator = Accelerator::none}, 1000, prepared).nodes, 0u);
}

}  // namespace
}  // namespace ps::space_tree_test
