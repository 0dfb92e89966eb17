#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <random>
#include <string>

#include "accel/octree.h"
#include "accel/triangle_box.h"
#include "base/parallel.h"
#include "base/stop.h"
#include "frame/prepared.h"
#include "raytrace/base/accelerators.h"
#include "raytrace/base/trace_inputs.h"
#include "render/render.h"
#include "scene/scene_file.h"

namespace ps::coincident_octree_test {
namespace {

Scene coincident_teapots(int copies) {
  std::string text = "model { name = t generator = teapot divisions = 2 } light { type = ambient intensity = 0.5 }";
  for (int i = 0; i < copies; ++i) text += " instance { model = t position = (0,0,9) }";
  return parse_scene(text, "teapots.scene", ".");
}

Settings with_octree() {
  Settings settings;
  settings.accelerator = Accelerator::octree;
  return settings;
}

template <class Real>
std::size_t entries_of_octree(const Scene& scene) {
  Prepared prepared;
  const auto geometry = traced_geometry<Real>(scene, with_octree(), prepared);
  const auto accelerator = traced_accelerator<Real>(scene, geometry, with_octree(), prepared);
  return accelerator_as<Octree<Real>>(accelerator)->entries.size();
}

TEST(CoincidentOctree, ListsEachCopyAsOftenAsOneAlone) {
  constexpr int copies = 60;  // far more than the 8 primitives that a cell may hold
  EXPECT_EQ(entries_of_octree<float>(coincident_teapots(copies)),
            copies * entries_of_octree<float>(coincident_teapots(1)));
  EXPECT_EQ(entries_of_octree<double>(coincident_teapots(9)), 9 * entries_of_octree<double>(coincident_teapots(1)));
}

TEST(CoincidentOctree, EntriesAreCounted) {
  const Scene scene = coincident_teapots(2);
  const View view{scene.camera, 8, 8};
  const std::size_t entries = entries_of_octree<float>(scene);
  EXPECT_GT(entries, 2u * 32 * 2 * 2 * 2) << "some triangles must stand in several cells";
  EXPECT_EQ(render(scene, view, with_octree()).counters[Counter::octree_entries], entries);
  EXPECT_EQ(render(scene, view, Settings()).counters[Counter::octree_entries], 0u);
}

TEST(CoincidentOctree, DrawsWhatTestingEverythingDraws) {
  const Scene scene = coincident_teapots(20);
  const View view{scene.camera, 24, 24};
  for (const Simd simd : {Simd::automatic, Simd::off}) {
    Settings octree = with_octree(), none;
    octree.simd = none.simd = simd;
    none.accelerator = Accelerator::none;
    const Frame a = render(scene, view, octree), b = render(scene, view, none);
    for (int y = 0; y < 24; ++y)
      for (int x = 0; x < 24; ++x) ASSERT_EQ(a.colour.at(x, y), b.colour.at(x, y)) << x << ", " << y;
  }
}

using Corners = std::array<Vec3d, 3>;

/// `copies` of a grid of triangles, none in the very same place as another: moved by about 1e-9.
std::vector<Corners> nearly_coincident(int copies) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> shift(-1e-9, 1e-9);
  std::vector<Corners> triangles;
  for (int copy = 0; copy < copies; ++copy) {
    const Vec3d moved{shift(random), shift(random), shift(random)};
    for (int i = 0; i < 4; ++i)
      for (int k = 0; k < 4; ++k) {
        const Vec3d corner = Vec3d{i, k, i * k * 0.1} + moved;
        triangles.push_back({corner, corner + Vec3d{1, 0, 0}, corner + Vec3d{0, 1, 0}});
      }
  }
  return triangles;
}

std::size_t largest_leaf(const Octree<double>& octree) {
  std::size_t largest = 0;
  for (const OctreeNode<double>& node : octree.nodes)
    if (node.leaf) largest = std::max<std::size_t>(largest, node.count);
  return largest;
}

TEST(CoincidentOctree, SharesOutABoundedNumberOfEntriesAmongNearCopies) {
  const auto triangles = nearly_coincident(100);
  const auto count = static_cast<std::uint32_t>(triangles.size());
  const auto overlaps = [&](std::uint32_t i, const Box<double>& cell) {
    return triangle_overlaps_box(triangles[i], cell, 1e-12);
  };
  const Octree<double> octree = build_octree<double>({{-0.1, -0.1, -0.1}, {4.1, 4.1, 4.1}}, count, {8, 10}, overlaps);
  EXPECT_LE(octree.entries.size(), 64u * count + 4096);
  // Every part of the scene gets cells that are cut well below the whole: no leaf is left with a large share of it.
  EXPECT_LE(largest_leaf(octree), count / 2);
}

TEST(CoincidentOctree, StopsWithinAFewThousandTests) {
  const auto triangles = nearly_coincident(400);
  Progress progress;
  const StopScope scope(&progress);
  int after = 0;
  const auto overlaps = [&](std::uint32_t i, const Box<double>& cell) {
    if (progress.stop_requested()) ++after;
    if (i == 4000) progress.request_stop();
    return triangle_overlaps_box(triangles[i], cell, 1e-12);
  };
  EXPECT_THROW(build_octree<double>({{-0.1, -0.1, -0.1}, {4.1, 4.1, 4.1}}, static_cast<std::uint32_t>(triangles.size()),
                                    {8, 10}, overlaps),
               Cancelled);
  EXPECT_LT(after, 3 * 4096);
}

/// Everything that is built before a picture begins, asked to stop before it begins.
TEST(CoincidentOctree, EveryAcceleratorListensToCancellation) {
  const Scene scene =
      parse_scene("model { name = t generator = teapot divisions = 2 } instance { model = t position = (0,0,9) }"
                  "instance { model = t position = (3,0,9) } light { type = ambient intensity = 0.5 }",
                  "teapots.scene", ".");
  for (const Accelerator accelerator : {Accelerator::bvh, Accelerator::bounding_spheres, Accelerator::box,
                                        Accelerator::octree, Accelerator::two_level, Accelerator::embree}) {
    Settings settings;
    settings.accelerator = accelerator;
    Prepared prepared;
    traced_geometry<float>(scene, settings, prepared);
    Progress stopped;
    stopped.request_stop();
    const StopScope scope(&stopped);
    EXPECT_THROW(make_trace_inputs<float>(scene, View{scene.camera, 8, 8}, settings, prepared), Cancelled)
        << static_cast<int>(accelerator);
  }
}

TEST(CoincidentOctree, GeometryAndTessellationListenToCancellation) {
  const Scene scene =
      parse_scene("sphere { center=(0,0,3) radius=1 } light { type = ambient intensity = 0.5 }", "sphere.scene", ".");
  Progress stopped;
  stopped.request_stop();
  for (const Renderer renderer : {Renderer::ray_tracer, Renderer::rasterizer}) {
    Settings settings{.renderer = renderer};
    Prepared prepared;
    EXPECT_THROW(render(scene, {scene.camera, 8, 8}, settings, {}, prepared, stopped), Cancelled);
    EXPECT_EQ(prepared.bytes(), 0u) << "was built before the stop was noticed";
  }
}

TEST(StopScope, ReachesTheThreadsOfParallelFor) {
  for (const int threads : {1, 4}) {
    Progress stopped, inner;
    std::atomic<int> calls{0};
    {
      const StopScope scope(&stopped);
      EXPECT_THROW(parallel_for(1000, {.threads = threads}, inner,
                                [&](int, int) {
                                  ++calls;
                                  stopped.request_stop();
                                  check_stop();
                                }),
                   Cancelled);
    }
    EXPECT_LE(calls.load(), threads);
    EXPECT_NO_THROW(check_stop());  // the scope is over
  }
}

}  // namespace
}  // namespace ps::coincident_octree_test
