// A tree over boxes whose surface areas are infinite: no cut is cheaper than another, and still it must be a tree.
#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "accel/bvh.h"

namespace ps::bvh_overflow_test {
namespace {

TEST(BvhOverflow, AHugeBoxLeavesNoHugeLeaf) {
  for (const float bad : {1e38f, std::numeric_limits<float>::infinity()}) {
    std::vector<Box<float>> boxes(3200);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      const auto x = static_cast<float>(i);
      boxes[i].include(Vec3f(x, 0, 0));
      boxes[i].include(Vec3f(x + 1, 1, 1));
    }
    boxes[1234].include(Vec3f(bad));
    const Bvh<float> bvh = build_bvh<float>(boxes, {.threads = 1});
    std::vector<int> seen(boxes.size(), 0);
    for (const std::uint32_t primitive : bvh.order) ++seen[primitive];
    EXPECT_EQ(seen, std::vector<int>(boxes.size(), 1));
    for (const BvhNode<float>& node : bvh.nodes) EXPECT_LE(node.count, 4 * bvh_no_tree) << "with " << bad;
  }
}

}  // namespace
}  // namespace ps::bvh_overflow_test
