// The tree of boxes is built for its first user.
#include "raytrace/base/bvh_on_demand.h"

#include <gtest/gtest.h>

#include <thread>
#include <vector>

#include "base/stop.h"
#include "render/render.h"
#include "scene/load.h"

namespace ps::bvh_on_demand_test {
namespace {

struct Teapot {
  Scene scene = load_scene("cgpp/teapot");
  View view{scene.camera, 64, 48};
  Settings settings{.accelerator = Accelerator::bvh};
  Prepared prepared;
  Progress progress;

  std::shared_ptr<const BvhOnDemand<float>> bvh() {
    return traced_bvh<float>(scene, traced_geometry<float>(scene, settings, prepared), prepared);
  }
};

// The machinery that draws the picture by SIMD has a tree of its own; the story of a pixel walks this one.
TEST(BvhOnDemand, APictureBySimdDoesWithoutIt) {
  Teapot teapot;
  const Frame frame = render(teapot.scene, teapot.view, teapot.settings, {}, teapot.prepared, teapot.progress);
  if (frame.path.machinery != Machinery::wide_triangles) GTEST_SKIP() << "this processor has no SIMD that searches";
  const std::size_t drawn = teapot.prepared.bytes(), unbuilt = teapot.bvh()->heap_bytes();
  EXPECT_EQ(teapot.prepared.bytes(), drawn) << "the picture's inputs have a place for it";
  const PixelStory story =
      inspect(teapot.scene, teapot.view, teapot.settings, {32, 24}, teapot.prepared, teapot.progress);
  EXPECT_GT(story.counters[Counter::node_visits], 0u);
  const Bvh<float>& tree = teapot.bvh()->tree();
  EXPECT_EQ(teapot.bvh()->heap_bytes(), unbuilt + tree.heap_bytes());
  EXPECT_EQ(teapot.prepared.bytes(), drawn + tree.heap_bytes()) << "what it takes now is counted";
}

TEST(BvhOnDemand, TheClearPathBuildsItBeforeItsFirstRay) {
  Teapot teapot;
  teapot.settings.simd = Simd::off;
  const std::size_t unbuilt = teapot.bvh()->heap_bytes();
  const Frame frame = render(teapot.scene, teapot.view, teapot.settings, {}, teapot.prepared, teapot.progress);
  EXPECT_EQ(frame.path.machinery, Machinery::clear);
  EXPECT_GT(teapot.bvh()->heap_bytes(), unbuilt);
}

TEST(BvhOnDemand, ThreadsThatAskTogetherGetOneTree) {
  Teapot teapot;
  const auto bvh = teapot.bvh();
  std::vector<const Bvh<float>*> found(8);
  {
    std::vector<std::jthread> threads;
    for (const Bvh<float>*& tree : found) threads.emplace_back([&] { tree = &bvh->tree(); });
  }
  EXPECT_EQ(found, std::vector<const Bvh<float>*>(8, &bvh->tree()));
  EXPECT_GT(bvh->tree().nodes.size(), 100u);
}

// A stopped builder leaves no half of a tree: the next caller builds all of it.
TEST(BvhOnDemand, AStoppedBuildBeginsAgain) {
  Teapot teapot;
  const auto bvh = teapot.bvh();
  const std::size_t unbuilt = bvh->heap_bytes();
  {
    teapot.progress.request_stop();
    const StopScope stopped(&teapot.progress);
    EXPECT_THROW(bvh->tree(), Cancelled);
  }
  EXPECT_EQ(bvh->heap_bytes(), unbuilt);
  EXPECT_EQ(bvh->tree().order.size(),
            traced_geometry<float>(teapot.scene, teapot.settings, teapot.prepared)->primitives.size());
}

}  // namespace
}  // namespace ps::bvh_on_demand_test
