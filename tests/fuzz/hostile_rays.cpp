#include "fuzz/hostile_rays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <vector>

#include "accel/bounding_spheres.h"
#include "accel/octree.h"
#include "accel/wide_bvh.h"
#include "accel/wide_octree.h"
#include "base/check.h"
#include "raytrace/clear/intersector-inl.h"
#include "raytrace/fast/fast_intersector.h"
#include "study/stability/plain_scene.h"
#include "support/all_accelerators.h"
#include "support/simd_targets.h"

namespace ps::fuzz {
namespace {

template <class Real>
Real hostile_number(const Draws& draw) {
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
  return numbers[draw() % numbers.size()];
}

template <class Real>
Vec3<Real> hostile_vector(const Draws& draw) {
  const auto one = [&] { return draw() % 3 == 0 ? hostile_number<Real>(draw) : static_cast<Real>(draw() % 9) / 4 - 1; };
  const Real x = one(), y = one();
  return {x, y, one()};
}

template <class Real>
Ray<Real> hostile_ray(const Draws& draw, std::uint32_t primitives) {
  Ray<Real> ray{hostile_vector<Real>(draw), hostile_vector<Real>(draw), 0, std::numeric_limits<Real>::infinity(),
                no_primitive};
  if (draw() % 4 == 0) ray.t_min = hostile_number<Real>(draw);
  if (draw() % 4 == 0) ray.t_max = hostile_number<Real>(draw);
  if (draw() % 4 == 0) ray.start = static_cast<std::uint32_t>(draw() % primitives);
  return ray;
}

template <class Real>
void check(const Ray<Real>& ray, const Hit<Real>& hit, std::uint32_t primitives) {
  if (!hit.found()) return;
  PS_ASSERT(is_finite(ray.origin) && is_finite(ray.direction), "only a ray finds something");
  PS_ASSERT(hit.primitive < primitives, "a hit is one of the primitives");
  PS_ASSERT(!std::isnan(hit.t), "a hit has a place");
}

template <class Real>
void search_with(const Scene& scene, const Settings& settings, int count, const Draws& draw) {
  Prepared prepared;
  const TraceInputs<Real> inputs = make_trace_inputs<Real>(scene, View{}, settings, prepared);
  const std::uint32_t primitives = primitive_count(*inputs.geometry);
  Silent silent;
  const Intersector<Real, Silent> clear(inputs, silent);
  std::vector<Ray<Real>> rays;
  for (int i = 0; i < count; ++i) rays.push_back(hostile_ray<Real>(draw, primitives));
  for (const Ray<Real>& ray : rays) {
    check(ray, clear.nearest(ray), primitives);
    check(ray, clear.any(ray), primitives);
  }
  if constexpr (std::is_same_v<Real, float>) {
    const std::optional<WideInputs> wide = wide_inputs(scene, inputs, prepared);
    if (!wide) return;
    CountingRecorder recorder;
    const FastIntersector fast(inputs, *wide, recorder);
    for (const Ray<float>& ray : rays) {
      check(ray, fast.nearest(ray), primitives);
      check(ray, fast.any(ray), primitives);
    }
    std::vector<Hit<float>> hits(rays.size());
    fast.nearest_of_each(rays, hits);
    for (std::size_t i = 0; i < rays.size(); ++i) check(rays[i], hits[i], primitives);
  }
}

/// Trees over boxes, balls and triangles of hostile numbers.
struct HostileTrees {
  std::vector<Box<float>> boxes;
  std::vector<WideTriangle> triangles;
  Bvh<float> bvh;
  Octree<float> octree;
  WideBvh wide, from_octree;
  BoundingSpheres spheres;
};

HostileTrees hostile_trees(std::size_t count, const Draws& draw) {
  HostileTrees trees;
  trees.boxes.resize(count);
  trees.triangles.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    WideTriangle& triangle = trees.triangles[i];
    for (Vec3f* corner : {&triangle.a, &triangle.b, &triangle.c}) *corner = hostile_vector<float>(draw);
    triangle.primitive = static_cast<std::uint32_t>(i);
    if (draw() % 2 == 0) {
      const Vec3f low = hostile_vector<float>(draw);
      trees.boxes[i] = {low, hostile_vector<float>(draw)};
    } else {
      for (const Vec3f& corner : {triangle.a, triangle.b, triangle.c}) trees.boxes[i].include(corner);
    }
  }
  const auto& boxes = trees.boxes;
  const auto& triangles = trees.triangles;
  trees.bvh = build_bvh<float>(boxes, {.threads = 1});
  trees.wide = widen(
      trees.bvh, [&](std::uint32_t i) { return triangles[i]; }, 1);
  const auto touches = [&](std::uint32_t i, const Box<float>& cell) {
    return !(boxes[i].low.x > cell.high.x || boxes[i].high.x < cell.low.x);
  };
  trees.octree = build_octree<float>({Vec3f(-1e20f), Vec3f(1e20f)}, static_cast<std::uint32_t>(count), {}, touches);
  trees.from_octree =
      widen_octree(trees.octree, [&](std::uint32_t i) { return std::optional<WideTriangle>(triangles[i]); });
  std::vector<BoundedPrimitive> balls(count);
  for (BoundedPrimitive& ball : balls) {
    const Vec3d centre = hostile_vector<double>(draw);
    ball = {centre, hostile_number<double>(draw), 0};
  }
  trees.spheres = build_bounding_spheres(balls);
  return trees;
}

void search_wide(const HostileTrees& trees, const Ray<float>& ray, float pad) {
  for (const Simd simd : test::simd_targets())
    for (const SimdTriangleTest test : {SimdTriangleTest::watertight, SimdTriangleTest::moeller_trumbore}) {
      const WideSearches searches = wide_searches(simd, test);
      for (const WideBvh* tree : {&trees.wide, &trees.from_octree})
        for (const WideSearch search : {searches.nearest, searches.any}) {
          Hit<float> best;
          best.t = ray.t_max;
          WideCount count;
          search(*tree, {ray, pad, 0}, best, count);
          PS_ASSERT(count.nodes <= tree->nodes.size(), "no node is entered twice");
        }
    }
}

}  // namespace

Scene hostile_scene(int triangles, const Draws& draw) {
  const auto number = [&] { return static_cast<double>(draw()) * 0x1p-31 - 1; };
  const auto vector = [&](double size) {
    const double x = number() * size, y = number() * size;
    return Vec3d(x, y, number() * size);
  };
  auto mesh = std::make_shared<Mesh>();
  mesh->materials = {0};
  for (int i = 0; i < triangles; ++i) {
    const double size = std::pow(10, i % 3 == 0 ? number() * 15 - 15 : number() * 3);
    const Vec3d corner = draw() % 2 == 0 ? vector(1) : vector(size);
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
  return plain_scene(std::move(geometry));
}

void search_scene(const Scene& scene, const Settings& settings, int rays, const Draws& draw) {
  if (settings.precision == Precision::float64)
    search_with<double>(scene, settings, rays, draw);
  else
    search_with<float>(scene, settings, rays, draw);
}

void search_trees(int boxes, int rays, const Draws& draw) {
  const auto count = static_cast<std::uint32_t>(boxes);
  const HostileTrees trees = hostile_trees(count, draw);
  for (int i = 0; i < rays; ++i) {
    const Ray<float> ray = hostile_ray<float>(draw, count);
    const CandidateRay<float> candidate{ray.origin, ray.direction, hostile_number<float>(draw)};
    Silent silent;
    std::size_t visits = 0;
    const auto visit = [&](std::uint32_t primitive) {
      PS_ASSERT(primitive < count, "a candidate is one of the primitives");
      ++visits;
      return false;
    };
    for_each_candidate(trees.bvh, candidate, ray.t_max, visit, silent);
    for_each_candidate(trees.spheres, candidate, ray.t_max, visit, silent);
    PS_ASSERT(visits <= 2u * count, "each primitive is a candidate once");
    for_each_candidate(trees.octree, candidate, ray.t_max, visit, silent);
    search_wide(trees, ray, candidate.pad);
  }
}

void search_as_bytes_say(std::string_view bytes) {
  std::uint32_t last = 1;
  const Draws draw = [&] {
    last = last * 1664525u + 1013904223u;  // for what the bytes leave open (Numerical Recipes, 7.1)
    std::uint32_t drawn = last ^ last >> 16;
    const std::size_t count = std::min(bytes.size(), sizeof drawn);
    std::memcpy(&drawn, bytes.data(), count);
    bytes.remove_prefix(count);
    return drawn;
  };
  Settings settings;
  const std::vector<Accelerator> accelerators = test::all_accelerators();
  std::vector<Simd> widths = test::simd_targets();
  widths.push_back(Simd::off);
  const std::uint32_t choice = draw();
  settings.accelerator = accelerators[choice % accelerators.size()];
  settings.simd = widths[choice / 16 % widths.size()];
  settings.triangle_test = choice / 64 % 2 == 0 ? TriangleTest::watertight : TriangleTest::moeller_trumbore;
  settings.precision = choice / 128 % 2 == 0 ? Precision::float32 : Precision::float64;
  search_scene(hostile_scene(1 + static_cast<int>(choice / 256 % 32), draw), settings, 16, draw);
  search_trees(1 + static_cast<int>(choice / 8192 % 64), 16, draw);
}

}  // namespace ps::fuzz
