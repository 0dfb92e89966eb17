// Rays and trees of hostile numbers (NaN, infinities, denormals, zeros, huge ones): every search ends, stays within its
// stack, and has no hit along a ray that is not one. PIXELSCOPE_FUZZ_SECONDS adds other seeds for that time
// (`tests/run --fuzz`); PIXELSCOPE_TEST_SEED is the first of them.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <iostream>
#include <optional>
#include <random>
#include <vector>

#include "accel/bvh.h"
#include "base/atomic_file.h"
#include "base/timer.h"
#include "fuzz/hostile_rays.h"
#include "support/all_accelerators.h"
#include "support/environment.h"
#include "support/simd_targets.h"
#include "support/trials.h"

namespace ps::hostile_rays_test {
namespace {

/// Some fixed seeds and then, while the time of a fuzz run lasts, others.
class Seeds {
 public:
  Seeds(unsigned first, unsigned count) : next_(first), fixed_left_(count) {}
  std::optional<unsigned> next() {
    if (fixed_left_ > 0) {
      --fixed_left_;
      return next_++;
    }
    if (timer_.milliseconds() >= 1000 * test::number_from("PIXELSCOPE_FUZZ_SECONDS", 0)) return {};
    if (!other_) other_ = test::test_seed();
    return (*other_)++;
  }

 private:
  unsigned next_, fixed_left_;
  std::optional<unsigned> other_;
  Timer timer_;
};

/// Draws of this seed, which it prints.
fuzz::Draws draws(unsigned seed) {
  std::cout << "seed " << seed << std::endl;  // a failed assertion ends the program
  return [random = std::mt19937(seed)]() mutable { return static_cast<std::uint32_t>(random()); };
}

TEST(HostileRays, EndInEverySearch) {
  Seeds seeds(11, 2);
  while (const auto seed = seeds.next()) {
    const Scene scene = fuzz::hostile_scene(300, draws(*seed));
    const fuzz::Draws first = draws(*seed);
    const auto search = [&](const Settings& settings) {
      fuzz::search_scene(scene, settings, test::trials(700), fuzz::Draws(first));  // the same rays for each
    };
    for (const Accelerator accelerator : test::all_accelerators())
      for (const TriangleTest test : {TriangleTest::watertight, TriangleTest::moeller_trumbore}) {
        Settings settings;
        settings.accelerator = accelerator;
        settings.triangle_test = test;
        std::vector<Simd> widths = test::simd_targets();
        widths.push_back(Simd::off);
        for (const Simd simd : widths) {
          settings.simd = simd;
          search(settings);
        }
        settings.precision = Precision::float64;
        search(settings);
      }
  }
}

/// The search's own kernels are given rays that is_searchable() would keep away, and boxes and triangles of such
/// numbers.
TEST(HostileRays, EndInTreesOfHostileNumbers) {
  Seeds seeds(21, 4);
  while (const auto seed = seeds.next()) {
    fuzz::search_trees(700, test::trials(1500), draws(*seed));
  }
}

/// What libFuzzer begins with and has found (tests/fuzz/fuzz_rays.cpp).
TEST(HostileRays, EndForTheKeptBytes) {
  int files = 0;
  for (const auto& file : std::filesystem::directory_iterator("tests/corpus/rays")) {
    std::cout << file.path() << std::endl;
    fuzz::search_as_bytes_say(read_whole_file(file.path()));
    ++files;
  }
  EXPECT_GE(files, 3);
}

TEST(HostileRays, FindNoTreeDeeperThanTheirStack) {
  // Each cut parts the farthest box from all others, which are far more than one worker builds alone.
  std::vector<Box<float>> boxes(40'000);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const float x = i < 240 ? std::ldexp(1.0f, 120 - static_cast<int>(i)) : 0.0f;
    boxes[i].include(Vec3f(x, 0, 0));
    boxes[i].include(Vec3f(x * 1.01f, 1e-3f, 1e-3f));
  }
  const Bvh<float> bvh = build_bvh<float>(boxes);
  std::vector<int> depth(bvh.nodes.size(), 0);
  int deepest = 0;
  for (std::size_t i = 0; i < bvh.nodes.size(); ++i) {
    deepest = std::max(deepest, depth[i]);
    if (bvh.nodes[i].count > 0) continue;
    depth[bvh.nodes[i].first] = depth[bvh.nodes[i].first + 1] = depth[i] + 1;
  }
  EXPECT_LT(deepest, bvh_max_depth);
}

}  // namespace
}  // namespace ps::hostile_rays_test
