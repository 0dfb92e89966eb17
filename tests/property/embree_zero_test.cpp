// Embree's rays with a 0 in their direction, in planes that hold corners of what they meet, such as the middle row of a
// picture whose camera stands level with a floor. They find what testing every triangle finds.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "base/machine.h"
#include "options/scene_settings.h"
#include "raytrace/base/trace_inputs.h"
#include "raytrace/clear/intersector.h"
#include "scene/load.h"
#include "support/environment.h"
#include "support/render_once.h"
#include "support/settings_with.h"
#include "support/trials.h"

namespace ps::embree_zero_test {
namespace {

/// From anywhere to a point of a triangle, but in the plane of a corner (`zeros` = 1), or in two such planes.
Ray<float> level_ray(const TracedGeometry<float>& geometry, std::mt19937& random, int zeros) {
  const auto triangle = [&]() -> const TracedTriangle<float>& {
    return geometry.triangles[random() % geometry.triangles.size()];
  };
  const auto unit = [&] { return static_cast<float>(random()) * 0x1p-32f; };
  const TracedTriangle<float>&target = triangle(), &other = triangle();
  const Vec3f level = std::array{other.a, other.b, other.c}[random() % 3];
  const float v = unit(), w = unit() * (1 - v);
  const Vec3f towards = target.a + (target.b - target.a) * v + (target.c - target.a) * w;
  Ray<float> ray;
  for (int i = 0; i < 3; ++i) {
    ray.origin[i] = (unit() * 4 - 2) * geometry.reach;
    ray.direction[i] = towards[i] - ray.origin[i];
  }
  const auto first = static_cast<int>(random() % 3);
  for (int k = 0; k < zeros; ++k) {
    const int axis = (first + k) % 3;
    ray.origin[axis] = level[axis];
    ray.direction[axis] = k == 0 ? 0.0f : -0.0f;
  }
  ray.t_max = std::numeric_limits<float>::infinity();
  return ray;
}

/// Not on an edge, where Embree's arithmetic may decide otherwise.
bool is_inside(const Hit<float>& hit) {
  return hit.found() && *std::min_element(hit.weights.begin(), hit.weights.end()) > 1e-4f;
}

TEST(EmbreeZero, LevelRaysFindWhatTestingEverythingFinds) {
  if (!has_embree()) GTEST_SKIP() << "Embree is not compiled in";
  const unsigned seed = test::test_seed(17);
  std::mt19937 random(seed);
  for (const char* name : {"cgfs/crates", "cgfs/cubes", "cgpp/teapot", "models/dice"}) {
    SCOPED_TRACE(std::string(name) + ", PIXELSCOPE_TEST_SEED=" + std::to_string(seed));
    const Scene scene = load_scene(name);
    Settings settings = settings_for(scene);
    settings.accelerator = Accelerator::embree;
    Prepared prepared;
    const TraceInputs<float> embree = make_trace_inputs<float>(scene, {scene.camera, 8, 8}, settings, prepared);
    TraceInputs<float> everything = embree;
    everything.accelerator = NoAccelerator{primitive_count(*embree.geometry)};
    Silent silent;
    const Intersector<float, Silent> expected_by(everything, silent), found_by(embree, silent);
    const int rays = test::trials(2000);
    int hits = 0, differing = 0, blocked_wrongly = 0;
    for (int i = 0; i < rays; ++i) {
      const Ray<float> ray = level_ray(*embree.geometry, random, 1 + i % 2);
      const Hit<float> expected = expected_by.nearest(ray), found = found_by.nearest(ray);
      if (!is_inside(expected) && !is_inside(found)) continue;
      ++hits;
      // Of triangles in one place, Embree may find another first.
      differing += std::abs(expected.t - found.t) <= 4e-7f * expected.t ? 0 : 1;
      blocked_wrongly += expected_by.any(ray).found() != found_by.any(ray).found() ? 1 : 0;
    }
    EXPECT_GT(hits, rays / 20);
    EXPECT_EQ(differing, 0);
    EXPECT_EQ(blocked_wrongly, 0);
  }
}

// The camera is level with faces of the crates, and the middle row of an odd number of rows with the camera.
TEST(EmbreeZero, TheMiddleRowOfThePictureIsWhole) {
  if (!has_embree()) GTEST_SKIP() << "Embree is not compiled in";
  const Scene scene = load_scene("cgfs/crates");
  Settings settings = settings_for(scene, Renderer::ray_tracer);
  Prepared prepared;
  const auto ids = [&](Accelerator accelerator) {
    settings.accelerator = accelerator;
    Progress progress;
    return render(scene, {scene.camera, 142, 101}, settings, request_for(Channel::ids), prepared, progress).ids;
  };
  const Image<PixelId> expected = ids(Accelerator::bvh), found = ids(Accelerator::embree);
  for (int x = 0; x < expected.width(); ++x) EXPECT_EQ(expected.at(x, 50), found.at(x, 50)) << x;
}

}  // namespace
}  // namespace ps::embree_zero_test
