// Rays and trees of hostile numbers (NaN, infinities, denormals, zeros, huge ones): every search ends, stays within its
// stack, and finds nothing along a ray that is no ray. PIXELSCOPE_FUZZ_SECONDS adds other seeds for that time
// (`tests/run --fuzz`); PIXELSCOPE_TEST_SEED is the first of them.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <vector>

#include "accel/bounding_spheres.h"
#include "accel/octree.h"
#include "accel/wide_bvh.h"
#include "accel/wide_octree.h"
#include "base/timer.h"
#include "raytrace/clear/intersector-inl.h"
#include "raytrace/fast/fast_intersector.h"
#include "support/all_accelerators.h"
#include "support/environment.h"
#include "support/simd_targets.h"
#include "support/trials.h"

namespace hostile_rays_test {
namespace {

using namespace ps;

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

template <class Real>
Real hostile_number(std::mt19937& random) {
  using Limits = std::numeric_limits<Real>;
  constexpr std::array<Real, 16> numbers{0,
                                         -Real(0),
                                         1,
                                         -1,
                                         Real(0.5),
                                         Limits::quiet_NaN(),
                                         Limits::infinity(),
                                         -Limits::infinity(),
                                         Limits::max(),
                                         Limits::lowest(),
                                         Limits::min(),
                                         Limits::denorm_min(),
                                         -Limits::denorm_min(),
                                         Real(1e-20),
                                         Real(1e20),
                                         Real(3e-13)};
  return numbers[random() % numbers.size()];
}

template <class Real>
Vec3<Real> hostile_vector(std::mt19937& random) {
  const auto one = [&] {
    return random() % 3 == 0 ? hostile_number<Real>(random) : static_cast<Real>(random() % 9) / 4 - 1;
  };
  const Real x = one(), y = one();
  return {x, y, one()};
}

template <class Real>
Ray<Real> hostile_ray(std::mt19937& random, std::uint32_t primitives) {
  Ray<Real> ray{hostile_vector<Real>(random), hostile_vector<Real>(random), 0, std::numeric_limits<Real>::infinity(),
                no_primitive};
  if (random() % 4 == 0) ray.t_min = hostile_number<Real>(random);
  if (random() % 4 == 0) ray.t_max = hostile_number<Real>(random);
  if (random() % 4 == 0) ray.start = static_cast<std::uint32_t>(random() % primitives);
  return ray;
}

/// Triangles, spheres and boxes of sizes from 1e-30 to 1e6, in a mesh and on their own.
Scene hostile_scene(std::mt19937& random) {
  const auto number = [&] { return static_cast<double>(random()) * 0x1p-31 - 1; };
  const auto vector = [&](double size) {
    const double x = number() * size, y = number() * size;
    return Vec3d(x, y, number() * size);
  };
  auto mesh = std::make_shared<Mesh>();
  mesh->materials = {0};
  for (int i = 0; i < 300; ++i) {
    const double size = std::pow(10, i % 3 == 0 ? number() * 15 - 15 : number() * 3);
    const Vec3d corner = random() % 2 == 0 ? vector(1) : vector(size);
    MeshTriangle triangle;
    for (std::size_t k = 0; k < 3; ++k) {
      triangle.position[k] = static_cast<std::uint32_t>(mesh->positions.size());
      mesh->positions.push_back(corner + (k == 0 ? Vec3d(0) : vector(size)));
    }
    mesh->triangles.push_back(triangle);
  }
  Geometry geometry;
  geometry.meshes = {mesh};
  geometry.objects.push_back({"mesh", Instance{}});
  for (int i = 0; i < 12; ++i)
    geometry.objects.push_back({"ball", Sphere{vector(1), std::pow(10, number() * 12 - 12), 0}});
  geometry.objects.push_back({"box", Solid{Brick{vector(1), {1e-22, 1, 1e5}}}});
  Scene scene;
  scene.geometry = Part<Geometry>(std::move(geometry));
  scene.materials = Part<std::vector<Material>>({Material{}});
  return scene;
}

template <class Real>
void expect_sound(const Ray<Real>& ray, const Hit<Real>& hit, std::uint32_t primitives) {
  if (!hit.found()) return;
  EXPECT_TRUE(is_finite(ray.origin) && is_finite(ray.direction));
  EXPECT_LT(hit.primitive, primitives);
  EXPECT_FALSE(std::isnan(hit.t));
}

/// Whatever searches there are for these settings.
template <class Real>
void search_with(const Scene& scene, const Settings& settings, unsigned seed) {
  Prepared prepared;
  const TraceInputs<Real> inputs = make_trace_inputs<Real>(scene, View{}, settings, prepared);
  const std::uint32_t primitives = primitive_count(*inputs.geometry);
  Silent silent;
  const Intersector<Real, Silent> clear(inputs, silent);
  std::mt19937 random(seed);
  std::vector<Ray<Real>> rays;
  for (int i = 0; i < test::trials(700); ++i) rays.push_back(hostile_ray<Real>(random, primitives));
  for (const Ray<Real>& ray : rays) {
    expect_sound(ray, clear.nearest(ray), primitives);
    expect_sound(ray, clear.any(ray), primitives);
  }
  if constexpr (std::is_same_v<Real, float>) {
    const std::optional<WideInputs> wide = wide_inputs(scene, inputs, prepared);
    if (!wide) return;
    CountingRecorder recorder;
    const FastIntersector fast(inputs, *wide, recorder);
    for (const Ray<float>& ray : rays) {
      expect_sound(ray, fast.nearest(ray), primitives);
      expect_sound(ray, fast.any(ray), primitives);
    }
    std::vector<Hit<float>> hits(rays.size());
    fast.nearest_of_each(rays, hits);
    for (std::size_t i = 0; i < rays.size(); ++i) expect_sound(rays[i], hits[i], primitives);
  }
}

TEST(HostileRays, EndInEverySearch) {
  Seeds seeds(11, 2);
  while (const auto drawn = seeds.next()) {
    const unsigned seed = *drawn;
    std::mt19937 random(seed);
    const Scene scene = hostile_scene(random);
    for (const Accelerator accelerator : test::all_accelerators())
      for (const TriangleTest test : {TriangleTest::watertight, TriangleTest::moeller_trumbore}) {
        SCOPED_TRACE("seed " + std::to_string(seed) + " accelerator " + std::to_string(static_cast<int>(accelerator)));
        Settings settings;
        settings.accelerator = accelerator;
        settings.triangle_test = test;
        std::vector<Simd> widths = test::simd_targets();
        widths.push_back(Simd::off);
        for (const Simd simd : widths) {
          settings.simd = simd;
          search_with<float>(scene, settings, seed);
        }
        search_with<double>(scene, settings, seed);
      }
  }
}

/// The search's own kernels are given rays that is_searchable() would keep away, and boxes and triangles of such
/// numbers.
TEST(HostileRays, EndInTreesOfHostileNumbers) {
  Seeds seeds(21, 4);
  while (const auto seed = seeds.next()) {
    SCOPED_TRACE("seed " + std::to_string(*seed));
    std::mt19937 random(*seed);
    std::vector<Box<float>> boxes(700);
    std::vector<WideTriangle> triangles(boxes.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      for (Vec3f* corner : {&triangles[i].a, &triangles[i].b, &triangles[i].c}) *corner = hostile_vector<float>(random);
      triangles[i].primitive = static_cast<std::uint32_t>(i);
      if (random() % 2 == 0)
        boxes[i] = {hostile_vector<float>(random), hostile_vector<float>(random)};
      else
        for (const Vec3f& corner : {triangles[i].a, triangles[i].b, triangles[i].c}) boxes[i].include(corner);
    }
    const Bvh<float> bvh = build_bvh<float>(boxes, 1);
    const WideBvh wide = widen(
        bvh, [&](std::uint32_t i) { return triangles[i]; }, 1);
    const auto touches = [&](std::uint32_t i, const Box<float>& cell) {
      return !(boxes[i].low.x > cell.high.x || boxes[i].high.x < cell.low.x);
    };
    const Octree<float> octree = build_octree<float>({Vec3f(-1e20f), Vec3f(1e20f)}, 700, {}, touches);
    const WideBvh from_octree =
        widen_octree(octree, [&](std::uint32_t i) { return std::optional<WideTriangle>(triangles[i]); });
    std::vector<BoundedPrimitive> balls(700);
    for (BoundedPrimitive& ball : balls) ball = {hostile_vector<double>(random), hostile_number<double>(random), 0};
    const BoundingSpheres spheres = build_bounding_spheres(balls);
    for (int i = 0; i < test::trials(1500); ++i) {
      const Ray<float> ray = hostile_ray<float>(random, 700);
      const CandidateRay<float> candidate{ray.origin, ray.direction, hostile_number<float>(random)};
      Silent silent;
      std::size_t visits = 0;
      const auto visit = [&](std::uint32_t primitive) {
        EXPECT_LT(primitive, 700u);
        ++visits;
        return false;
      };
      for_each_candidate(bvh, candidate, ray.t_max, visit, silent);
      for_each_candidate(spheres, candidate, ray.t_max, visit, silent);
      EXPECT_LE(visits, 2u * 700u);
      for_each_candidate(octree, candidate, ray.t_max, visit, silent);
      for (const Simd simd : test::simd_targets())
        for (const SimdTriangleTest test : {SimdTriangleTest::watertight, SimdTriangleTest::moeller_trumbore}) {
          const WideSearches searches = wide_searches(simd, test);
          for (const WideBvh* tree : {&wide, &from_octree})
            for (const WideSearch search : {searches.nearest, searches.any}) {
              Hit<float> best;
              best.t = ray.t_max;
              WideCount count;
              search(*tree, {ray, candidate.pad, 0}, best, count);
              EXPECT_LE(count.nodes, tree->nodes.size()) << "a node was entered twice";
            }
        }
    }
  }
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
}  // namespace hostile_rays_test
