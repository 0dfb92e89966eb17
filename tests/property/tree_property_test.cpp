// What trees hold, whatever is searched for in them: boxes that triangles overlap, children in their parents, and what
// stands outside. That searches find what testing everything finds is in accelerator_property_test.cpp.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "accel/binned_split.h"
#include "accel/bvh.h"
#include "accel/octree.h"
#include "accel/triangle_box.h"
#include "raytrace/base/trace_inputs.h"
#include "render/render.h"
#include "scene/scene_file.h"

namespace ps::tree_property_test {
namespace {

TEST(Trees, TriangleAndBoxAreApartWhereNoSampleOfTheTriangleIsInTheBox) {
  std::mt19937 random(86);
  const auto number = [&] { return static_cast<double>(random()) * 0x1p-31 - 1; };
  const auto vector = [&](double size) {
    const double x = number() * size, y = number() * size;
    return Vec3d(x, y, number() * size);
  };
  const Box<double> box{{-1, -0.5, -0.25}, {1, 0.5, 0.25}};
  int apart = 0, only_by_edges = 0;
  for (int i = 0; i < 3000; ++i) {
    const std::array<Vec3d, 3> p{vector(2.5), vector(2.5), vector(2.5)};
    bool touches = false;
    constexpr int steps = 60;
    for (int u = 0; u <= steps && !touches; ++u)
      for (int v = 0; u + v <= steps && !touches; ++v) {
        const Vec3d point = p[0] + (p[1] - p[0]) * (u / double{steps}) + (p[2] - p[0]) * (v / double{steps});
        touches = std::abs(point.x) <= 1 && std::abs(point.y) <= 0.5 && std::abs(point.z) <= 0.25;
      }
    const bool overlaps = triangle_overlaps_box(p, box, 0);
    if (touches) {
      EXPECT_TRUE(overlaps) << i;
    }
    if (overlaps) {
      continue;
    }
    ++apart;
    Box<double> around;
    for (const Vec3d& corner : p) around.include(corner);
    const bool boxes_touch = around.low.x <= 1 && around.high.x >= -1 && around.low.y <= 0.5 && around.high.y >= -0.5 &&
                             around.low.z <= 0.25 && around.high.z >= -0.25;
    only_by_edges += boxes_touch ? 1 : 0;
  }
  EXPECT_GT(apart, 100);
  EXPECT_GT(only_by_edges, 100) << "boxes alone would do";
}

TEST(Trees, TheTreeDoesNotDependOnThreads) {
  std::mt19937 random(85);
  const auto unit = [&] { return static_cast<float>(random()) * 0x1p-32f; };
  std::vector<Box<float>> boxes(150000);  // enough for the parallel part of the builder
  for (Box<float>& box : boxes) {
    const Vec3f corner{unit(), unit() * unit(), unit()};
    box.include(corner);
    box.include(corner + Vec3f(unit() * 0.01f, unit() * 0.01f, unit() * 0.01f));
  }
  const Bvh<float> one = build_bvh<float>(boxes, {.threads = 1});
  std::vector<int> seen(boxes.size(), 0);
  for (const std::uint32_t primitive : one.order) ++seen[primitive];
  EXPECT_EQ(seen, std::vector<int>(boxes.size(), 1));
  for (const int threads : {2, 7}) {
    const Bvh<float> other = build_bvh<float>(boxes, {.threads = threads});
    EXPECT_EQ(one.order, other.order);
    ASSERT_EQ(one.nodes.size(), other.nodes.size());
    EXPECT_EQ(std::memcmp(one.nodes.data(), other.nodes.data(), one.nodes.size() * sizeof one.nodes[0]), 0);
  }
  for (const BvhNode<float>& node : one.nodes) {  // each node holds its children and its primitives
    Box<float> content;
    for (std::uint32_t i = 0; i < node.count; ++i) content.include(boxes[one.order[node.first + i]]);
    if (node.count == 0)
      for (std::uint32_t k = 0; k < 2; ++k) content.include(one.nodes[node.first + k].box);
    ASSERT_TRUE(content.low == node.box.low && content.high == node.box.high);
  }
}

/// Cost of a search of the tree by the surface-area heuristic, `group` primitives being tested in one go.
double cost_of(const Bvh<float>& bvh, std::uint32_t group) {
  double cost = 0;
  for (const BvhNode<float>& node : bvh.nodes) {
    const std::uint32_t groups = (node.count + group - 1) / group;
    cost += static_cast<double>(node.box.half_area()) * (node.count == 0 ? bvh_traversal_cost : groups);
  }
  return cost;
}

// Cuts that count in the groups that a search tests make a tree that is cheaper for it than others do.
TEST(Trees, AreCutForTheSearchThatTestsThem) {
  std::mt19937 random(87);
  const auto unit = [&] { return static_cast<float>(random()) * 0x1p-32f; };
  for (int soup = 0; soup < 5; ++soup) {
    std::vector<Box<float>> boxes(4000);
    for (Box<float>& box : boxes) {
      const Vec3f corner{unit(), unit() * unit(), unit()};
      box.include(corner);
      box.include(corner + Vec3f(unit() * 0.05f, unit() * 0.05f, unit() * 0.05f));
    }
    const Bvh<float> fours = build_bvh<float>(boxes), eights = build_bvh<float>(boxes, {.group = 8});
    EXPECT_LT(cost_of(eights, 8), 0.97 * cost_of(fours, 8)) << soup;
    EXPECT_LT(cost_of(fours, 4), 0.97 * cost_of(eights, 4)) << soup;
    EXPECT_LT(eights.nodes.size(), fours.nodes.size()) << soup;
  }
}

// A plane in the tree would stand in every cell and make the box of everything endless.
TEST(Trees, PlanesStandOutsideOfEveryTree) {
  const std::string balls = [] {
    std::string text = "viewport_size = 1 x 1\nprojection_plane_d = 1\nbackground = black\n";
    for (int x = 0; x < 6; ++x)
      for (int z = 0; z < 6; ++z)
        text += "sphere { center = (" + std::to_string(x - 2.5) + ", 0, " + std::to_string(z + 4) +
                ") radius = 0.3 color = white }\n";
    return text + "light { type = point  intensity = 1  position = (0, 5, 2) }\n";
  }();
  const std::string plane = "plane { point = (0, -1, 0)  normal = (0, 1, 0)  color = white }\n";
  const Scene without = parse_scene(balls, "balls.scene", "."), with = parse_scene(plane + balls, "both.scene", ".");
  Prepared prepared;
  Progress progress;
  const View view{with.camera, 60, 40};
  std::optional<Frame> brute;
  for (const Accelerator accelerator :
       {Accelerator::none, Accelerator::bvh, Accelerator::octree, Accelerator::box, Accelerator::bounding_spheres}) {
    SCOPED_TRACE(static_cast<int>(accelerator));
    Settings settings;
    settings.accelerator = accelerator;
    settings.octree_leaf = 2;
    const Frame frame = render(with, view, settings, {}, prepared, progress);
    if (!brute) brute = frame;
    EXPECT_EQ(
        std::memcmp(brute->colour.pixels().data(), frame.colour.pixels().data(), frame.colour.pixels().size_bytes()),
        0);
    const TraceInputs<float> a = make_trace_inputs<float>(without, view, settings, prepared);
    const TraceInputs<float> b = make_trace_inputs<float>(with, view, settings, prepared);
    EXPECT_EQ(b.geometry->unbounded, std::vector<std::uint32_t>{0});
    if (accelerator == Accelerator::octree) {
      const auto& tree_without = *accelerator_as<Octree<float>>(a.accelerator);
      const auto& tree_with = *accelerator_as<Octree<float>>(b.accelerator);
      ASSERT_EQ(tree_without.nodes.size(), tree_with.nodes.size());
      EXPECT_EQ(tree_without.entries.size(), tree_with.entries.size());
      for (const std::uint32_t entry : tree_with.entries) EXPECT_GE(entry, 1u);
      EXPECT_TRUE(tree_without.nodes[0].box.high == tree_with.nodes[0].box.high);
      EXPECT_LT(frame.counters[Counter::sphere_tests], brute->counters[Counter::sphere_tests] / 3);
    }
    if (accelerator == Accelerator::bvh) {
      EXPECT_EQ(accelerator_as<BvhOnDemand<float>>(a.accelerator)->tree().nodes.size(),
                accelerator_as<BvhOnDemand<float>>(b.accelerator)->tree().nodes.size());
    }
  }
}

}  // namespace
}  // namespace ps::tree_property_test
