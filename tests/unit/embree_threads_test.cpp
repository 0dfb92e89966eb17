// Embree's trees are made, searched and let go by several threads at once. ThreadSanitizer reports it if two are made
// or let go at the same time; the numbers are those of one thread.
#include <gtest/gtest.h>

#include <atomic>
#include <deque>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "base/machine.h"
#include "base/progress.h"
#include "base/stop.h"
#include "raytrace/base/embree_triangles.h"
#include "raytrace/base/eye_ray.h"
#include "raytrace/base/trace_inputs.h"
#include "scene/load.h"
#include "support/trials.h"

namespace ps::embree_threads_test {
namespace {
using Tree = std::shared_ptr<const EmbreeTriangles>;

/// A scene of triangles, and the rays through a small picture of it.
struct Aimed {
  std::shared_ptr<const TracedGeometry<float>> geometry;
  std::vector<Ray<float>> rays;
};

Aimed tea_party() {
  const Scene scene = load_scene("lab/tea-party");
  Prepared prepared;
  const auto inputs = make_trace_inputs<float>(scene, View{scene.camera, 32, 32}, {}, prepared);
  Aimed aimed{inputs.geometry, {}};
  for (int i = 0; i < 32 * 32; ++i) aimed.rays.push_back(eye_ray(inputs, i % 32, i / 32, {0.5, 0.5}));
  return aimed;
}

/// How many triangles the rays meet, those behind each other too.
int met(const EmbreeTriangles& tree, const Aimed& aimed) {
  int count = 0;
  for (const Ray<float>& ray : aimed.rays)
    tree.for_each_candidate(ray, ray.t_max, false, [&](const EmbreeCandidate&) {
      ++count;
      return false;
    });
  return count;
}

constexpr int rounds = test::trial_divisor > 1 ? 3 : 6;

TEST(EmbreeThreads, MakeSearchAndLetGoOfEachOthersTrees) {
  if (!has_embree()) GTEST_SKIP() << "compiled without Embree";
  const Aimed aimed = tea_party();
  const int expected = met(EmbreeTriangles(*aimed.geometry), aimed);
  ASSERT_GT(expected, 100);
  std::mutex mutex;
  std::deque<Tree> trees;
  std::atomic<int> different = 0;
  std::vector<std::thread> threads;
  for (int thread = 0; thread < 4; ++thread)
    threads.emplace_back([&] {
      for (int i = 0; i < rounds; ++i) {
        const auto made = std::make_shared<const EmbreeTriangles>(*aimed.geometry);
        Tree other;  // often another thread's, which has let go of it by then
        {
          const std::lock_guard lock(mutex);
          trees.push_back(made);
          if (trees.size() > 3) {
            other = trees.front();
            trees.pop_front();
          }
        }
        different += met(*made, aimed) != expected || (other && met(*other, aimed) != expected) ? 1 : 0;
      }
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(different, 0);
}

/// A build that is stopped is let go as one that is whole, and leaves its turn to the next.
TEST(EmbreeThreads, AStoppedBuildLeavesItsTurn) {
  if (!has_embree()) GTEST_SKIP() << "compiled without Embree";
  const Aimed aimed = tea_party();
  Progress progress;
  progress.request_stop();
  {
    const StopScope listens(&progress);
    EXPECT_THROW(EmbreeTriangles{*aimed.geometry}, Cancelled);
  }
  EXPECT_GT(met(EmbreeTriangles(*aimed.geometry), aimed), 100);
}

}  // namespace
}  // namespace ps::embree_threads_test
