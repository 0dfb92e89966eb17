// All accelerators must find the very hit that testing everything finds: the same primitive, t and weights to the last
// bit. Rays are aimed within an ulp of vertices and edges, where boxes and triangles are easiest to miss; random rays
// would not notice a wrong box in a million.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <iostream>
#include <optional>
#include <random>

#include "base/machine.h"
#include "raytrace/fast/fast_intersector.h"
#include "study/stability/plain_scene.h"
#include "support/closed_sphere.h"
#include "support/same_bits.h"
#include "support/simd_targets.h"
#include "support/trials.h"

namespace ps::accelerator_property_test {
namespace {

struct Place {
  const char* name;
  double size;
  Vec3d centre;
};
const Place places[] = {{"at the origin", 1, {0, 0, 0}},
                        {"tiny", 1e-6, {0, 0, 0}},
                        {"huge", 1e7, {3e6, 0, -1e6}},
                        {"far away", 1, {2e4, -3e4, 1e4}},
                        {"where floats are 1/16 apart", 1, {1e6, 0, -5e5}}};

/// Some scenes have triangles that are seen from their front alone.
Sides sides_of(unsigned seed) { return seed % 3 == 2 ? Sides::front : Sides::two; }

/// Two closed spheres of triangles, one in the other, loose triangles of all sizes, and a few true spheres.
Scene aimed_scene(const Place& place, unsigned seed) {
  std::mt19937 random(seed);
  const auto number = [&](double size) { return (static_cast<double>(random()) * 0x1p-31 - 1) * size; };
  const auto vector = [&](double size) {
    const double x = number(size), y = number(size);
    return Vec3d(x, y, number(size));
  };
  auto mesh = std::make_shared<Mesh>();
  mesh->materials = {0};
  const auto add = [&](const Vec3d& a, const Vec3d& b, const Vec3d& c) {
    const auto first = static_cast<std::uint32_t>(mesh->positions.size());
    for (const Vec3d& corner : {a, b, c}) mesh->positions.push_back(corner);
    MeshTriangle triangle;
    triangle.position = {first, first + 1, first + 2};
    mesh->triangles.push_back(triangle);
  };
  for (const double radius : {1.0, 2.5}) {
    const test::ClosedSphere sphere = test::closed_sphere(12, 18, radius * place.size, place.centre);
    for (std::size_t i = 0; i < sphere.triangles.size(); ++i) {
      const TracedTriangle<float> t = sphere.triangle(i);
      add(Vec3d(t.a), Vec3d(t.b), Vec3d(t.c));
    }
  }
  for (int i = 0; i < 150; ++i) {
    const double size = place.size * std::exp(number(4) - 3);
    const Vec3d corner = place.centre + vector(3 * place.size);
    add(corner, corner + vector(size), corner + vector(size));
    if (i % 10 == 0) add(corner, corner + vector(size), corner + vector(size));
  }
  for (int i = 0; i < 10; ++i) {  // a copy of an earlier triangle: ties everywhere
    const auto copy = mesh->triangles[random() % mesh->triangles.size()];
    mesh->triangles.push_back(copy);
  }
  Geometry geometry;
  geometry.meshes = {mesh};
  for (int i = 0; i < 12; ++i)
    geometry.objects.push_back({"ball", Sphere{place.centre + vector(2 * place.size), place.size * 0.1 * (i + 1), 0}});
  Instance instance;
  instance.sides = sides_of(seed);
  geometry.objects.insert(geometry.objects.begin() + 5, {"mesh", instance});
  return plain_scene(std::move(geometry));
}

template <class Real>
std::vector<Ray<Real>> aimed_rays(const TracedGeometry<Real>& geometry, const Place& place, unsigned seed,
                                  int count = 1500) {
  std::mt19937 random(seed);
  const auto unit = [&] { return static_cast<Real>(static_cast<double>(random()) * 0x1p-32); };
  const auto within_an_ulp = [&](Real x) {
    const Real towards = std::numeric_limits<Real>::infinity() * static_cast<Real>(static_cast<int>(random() % 3) - 1);
    return random() % 3 == 0 || std::isnan(towards) ? x : std::nextafter(x, towards);
  };
  std::vector<Ray<Real>> rays;
  for (int i = 0; i < count; ++i) {
    const auto& triangle = geometry.triangles[random() % geometry.triangles.size()];
    Vec3<Real> target = triangle.a;
    if (i % 3 == 1) target = triangle.a + (triangle.b - triangle.a) * unit();
    if (i % 3 == 2) target = (triangle.a + triangle.b + triangle.c) / Real(3);
    Ray<Real> ray;
    for (int axis = 0; axis < 3; ++axis) {
      ray.origin[axis] =
          static_cast<Real>(place.centre[axis]) + (unit() - Real(0.5)) * static_cast<Real>(6 * place.size);
      target[axis] = within_an_ulp(target[axis]);
      if (random() % 8 == 0) ray.origin[axis] = target[axis];  // along a plane or an axis, in a box's side
    }
    if (ray.origin == target) continue;
    ray.direction = target - ray.origin;
    ray.t_max = i % 5 == 0 ? Real(1) : std::numeric_limits<Real>::infinity();
    if (i % 11 == 0) ray.direction = ray.direction * Real(1e-18);  // beyond what the wide tree's boxes take
    if (i % 7 == 0) {                                              // leaves the surface of a triangle
      const auto start = static_cast<std::uint32_t>(random() % geometry.primitives.size());
      if (geometry.primitives[start].kind == PrimitiveKind::triangle) ray.start = start;
      ray.direction = ray.direction * Real(0.001);
    }
    rays.push_back(ray);
  }
  return rays;
}

template <class Real>
bool same_bits(const Hit<Real>& a, const Hit<Real>& b) {
  if (a.primitive != b.primitive) return false;
  return !a.found() || (test::same_bits(a.t, b.t) && test::same_bits(a.weights, b.weights));
}

/// The same inputs, to test every primitive one by one.
template <class Real>
TraceInputs<Real> without_accelerator(TraceInputs<Real> inputs) {
  inputs.accelerator = NoAccelerator{primitive_count(*inputs.geometry)};
  return inputs;
}

/// Rays, and what each finds when every primitive is tested.
template <class Real>
struct Expected {
  std::vector<Ray<Real>> rays;
  std::vector<Hit<Real>> hits;
};

template <class Real>
Expected<Real> by_testing_everything(const TraceInputs<Real>& inputs, std::vector<Ray<Real>> rays) {
  const TraceInputs<Real> everything = without_accelerator(inputs);
  Silent silent;
  const Intersector<Real, Silent> clear(everything, silent);
  Expected<Real> result{std::move(rays), {}};
  for (const Ray<Real>& ray : result.rays) result.hits.push_back(clear.nearest(ray));
  return result;
}

/// How many of the rays find something else with `search`.
template <class Real>
int differences(const RaySearch<Real>& search, const Expected<Real>& expected) {
  int result = 0;
  for (std::size_t i = 0; i < expected.rays.size(); ++i) {
    const Ray<Real>& ray = expected.rays[i];
    const Hit<Real>& hit = expected.hits[i];
    result += same_bits(hit, search.nearest(ray)) && hit.found() == search.any(ray).found() ? 0 : 1;
  }
  return result;
}
/// The same for the clear path's search.
template <class Real>
int differences(const TraceInputs<Real>& inputs, const Expected<Real>& expected) {
  Silent silent;
  return differences<Real>(Intersector<Real, Silent>(inputs, silent), expected);
}
template <class Real>
int differences(const TraceInputs<Real>& inputs, const std::vector<Ray<Real>>& rays) {
  return differences(inputs, by_testing_everything(inputs, rays));
}
/// The same for the SIMD search, where there is one.
int fast_differences(const Scene& scene, const TraceInputs<float>& inputs, const Expected<float>& expected,
                     Prepared& prepared) {
  const std::optional<WideInputs> wide = wide_inputs(scene, inputs, prepared);
  CountingRecorder recorder;
  return wide ? differences<float>(FastIntersector(inputs, *wide, recorder), expected) : 0;
}

struct Way {
  Accelerator accelerator;
  Simd simd;
};
const Way ways[] = {{Accelerator::bvh, Simd::off},      {Accelerator::bvh, Simd::sse4},
                    {Accelerator::bvh, Simd::avx2},     {Accelerator::bvh, Simd::avx512},
                    {Accelerator::none, Simd::sse4},    {Accelerator::none, Simd::avx2},
                    {Accelerator::none, Simd::avx512},  {Accelerator::bounding_spheres, Simd::off},
                    {Accelerator::box, Simd::off},      {Accelerator::octree, Simd::off},
                    {Accelerator::octree, Simd::sse4},  {Accelerator::octree, Simd::avx2},
                    {Accelerator::octree, Simd::avx512}};

template <class Real>
void expect_same_hits(TriangleTest test) {
  for (unsigned seed = 81; seed < 81u + static_cast<unsigned>(test::trials(3)); ++seed) {
    for (const Place& place : places) {
      SCOPED_TRACE(std::string(place.name) + ", seed " + std::to_string(seed));
      const Scene scene = aimed_scene(place, seed);
      Prepared prepared;
      std::shared_ptr<const TracedGeometry<Real>> searched;
      Expected<Real> expected;
      for (const Way& way : ways) {
        SCOPED_TRACE(std::to_string(static_cast<int>(way.accelerator)) + "/" +
                     std::to_string(static_cast<int>(way.simd)));
        Settings settings;
        settings.triangle_test = test;
        settings.accelerator = way.accelerator;
        settings.simd = way.simd;
        const TraceInputs<Real> inputs = make_trace_inputs<Real>(scene, View{}, settings, prepared);
        if (searched != inputs.geometry) {
          searched = inputs.geometry;
          expected = by_testing_everything(inputs, aimed_rays(*searched, place, seed, test::trials(1500)));
        }
        if (way.simd == Simd::off) {
          EXPECT_EQ(differences(inputs, expected), 0);
        }
        if constexpr (std::is_same_v<Real, float>) {
          EXPECT_EQ(fast_differences(scene, inputs, expected, prepared), 0);
        }
      }
    }
  }
}

TEST(Accelerators, FindTheHitOfTheWatertightTest) { expect_same_hits<float>(TriangleTest::watertight); }
TEST(Accelerators, FindTheHitOfMoellerTrumbore) { expect_same_hits<float>(TriangleTest::moeller_trumbore); }
TEST(Accelerators, FindTheHitInDouble) { expect_same_hits<double>(TriangleTest::watertight); }

/// Rays of neighbours are searched for together: sixteen around each of the aimed ones.
void expect_same_hits_together(Accelerator accelerator, Simd narrowest) {
  std::vector<Simd> widths = test::simd_targets();
  std::erase_if(widths, [&](Simd simd) { return simd < narrowest; });
  if (widths.empty()) GTEST_SKIP() << "this processor has no SIMD target that searches for rays together";
  for (const TriangleTest test : {TriangleTest::watertight, TriangleTest::moeller_trumbore}) {
    for (const Place& place : places) {
      for (const Simd simd : widths) {
        const unsigned seed = (static_cast<unsigned>(&place - places) + static_cast<unsigned>(simd)) % 2 == 0 ? 81 : 83;
        SCOPED_TRACE(fmt::format("{}, seed {}, SIMD {}", place.name, seed, static_cast<int>(simd)));
        const Scene scene = aimed_scene(place, seed);
        Prepared prepared;
        Settings settings;
        settings.triangle_test = test;
        settings.accelerator = accelerator;
        settings.simd = simd;
        const TraceInputs<float> inputs = make_trace_inputs<float>(scene, View{}, settings, prepared);
        const std::optional<WideInputs> wide = wide_inputs(scene, inputs, prepared);
        ASSERT_TRUE(wide && (wide->list || wide->packets.nearest));
        const TraceInputs<float> everything = without_accelerator(inputs);
        Silent silent;
        CountingRecorder recorder;
        const Intersector<float, Silent> clear(everything, silent);
        const FastIntersector fast(inputs, *wide, recorder);
        CountingRecorder alone;
        const FastIntersector one_by_one(inputs, *wide, alone);
        int differing = 0, together = 0;
        for (const Ray<float>& ray : aimed_rays(*inputs.geometry, place, seed, test::trials(1500))) {
          std::array<Ray<float>, most_in_packet> rays;
          std::array<Hit<float>, most_in_packet> hits;
          for (std::size_t i = 0; i < most_in_packet; ++i) {
            rays[i] = ray;
            for (int axis = 0; axis < 3 && i > 0; ++axis)  // from an ulp to a percent
              rays[i].direction[axis] *= 1 + std::ldexp(static_cast<float>(axis + 1), -24 + static_cast<int>(i));
          }
          WidePacket packet;
          const std::span<const Ray<float>> some(rays.data(), std::min(most_in_packet, wide->packets.width));
          together += wide->list || wide->packets.make(some, wide->seen, inputs.box_padding, packet) ? 1 : 0;
          const std::size_t count = 1 + static_cast<std::size_t>(together) % most_in_packet;
          fast.nearest_of_each(std::span<const Ray<float>>(rays.data(), count), std::span(hits.data(), count));
          for (std::size_t i = 0; i < count; ++i) {
            differing += same_bits(clear.nearest(rays[i]), hits[i]) ? 0 : 1;
            one_by_one.nearest(rays[i]);
          }
        }
        EXPECT_EQ(differing, 0);
        EXPECT_GT(together, test::trials(1500) * 2 / 3);
        for (const Counter work : {Counter::node_visits, Counter::triangle_tests})
          EXPECT_NEAR(static_cast<double>(recorder.counters[work]), static_cast<double>(alone.counters[work]),
                      0.01 * static_cast<double>(alone.counters[work]));  // one box of all spheres turns more away
      }
    }
  }
}

TEST(Accelerators, RaysThroughTheTreeTogetherFindWhatEachFinds) {
  expect_same_hits_together(Accelerator::bvh, Simd::avx2);
}
TEST(Accelerators, RaysThroughTheOctreeTogetherFindWhatEachFinds) {
  expect_same_hits_together(Accelerator::octree, Simd::avx2);
}
TEST(Accelerators, RaysPastEverythingTogetherFindWhatEachFinds) {
  expect_same_hits_together(Accelerator::none, Simd::sse4);
}

/// A packet that passes the model is done at the root, which counts once for each of its rays.
TEST(Accelerators, RaysThatMissTogetherCountTheRootEach) {
  const Scene scene = aimed_scene(places[0], 81);
  Prepared prepared;
  const TraceInputs<float> inputs = make_trace_inputs<float>(scene, View{}, Settings{}, prepared);
  const std::optional<WideInputs> wide = wide_inputs(scene, inputs, prepared);
  if (!wide || !wide->packets.nearest) GTEST_SKIP() << "this processor does not search for rays together";
  CountingRecorder work;
  const FastIntersector packets(inputs, *wide, work);
  std::array<Ray<float>, most_in_packet> rays;
  std::array<Hit<float>, most_in_packet> hits;
  for (std::size_t i = 0; i < most_in_packet; ++i) {
    rays[i].origin = Vec3f(100, 100, 100);
    rays[i].direction = Vec3f(1, 1 + 0.01f * static_cast<float>(i), 2);
  }
  packets.nearest_of_each(rays, hits);
  for (const Hit<float>& hit : hits) EXPECT_FALSE(hit.found());
  EXPECT_EQ(work.counters[Counter::node_visits], most_in_packet);
  EXPECT_EQ(work.counters[Counter::triangle_tests], 0u);
}

/// Boxes are grown by rounding errors of numbers as they are seen from the scene, not from the world's origin: there
/// they would be larger than the boxes themselves, and a ray would test every triangle.
TEST(Accelerators, RejectFarFromTheOriginWhatTheyRejectThere) {
  const auto tests_per_ray = [](const Place& place, Accelerator accelerator, bool with_simd) {
    const Scene scene = aimed_scene(place, 81);
    Prepared prepared;
    Settings settings;
    settings.accelerator = accelerator;
    const TraceInputs<float> inputs = make_trace_inputs<float>(scene, View{}, settings, prepared);
    const std::optional<WideInputs> wide = with_simd ? wide_inputs(scene, inputs, prepared) : std::nullopt;
    CountingRecorder recorder;
    std::unique_ptr<RaySearch<float>> search;
    if (wide)
      search = std::make_unique<FastIntersector>(inputs, *wide, recorder);
    else
      search = std::make_unique<Intersector<float, CountingRecorder>>(inputs, recorder);
    const std::vector<Ray<float>> rays = aimed_rays(*inputs.geometry, place, 81);
    for (const Ray<float>& ray : rays)
      if (std::abs(ray.direction.z) > 1e-10f) search->nearest(ray);  // others are searched by the clear path
    return static_cast<double>(recorder.counters[Counter::triangle_tests]) / static_cast<double>(rays.size());
  };
  for (const bool with_simd : {false, true}) {
    if (with_simd && test::simd_targets().empty()) continue;
    for (const Accelerator accelerator :
         {Accelerator::bvh, Accelerator::octree, Accelerator::box, Accelerator::bounding_spheres}) {
      const double here = tests_per_ray(places[0], accelerator, with_simd);
      for (const Place& place : {places[3], places[4]})
        EXPECT_LT(tests_per_ray(place, accelerator, with_simd), 1.3 * here) << place.name << ' ' << with_simd;
    }
  }
}

/// How far the ray's line passes from the triangle's nearest edge or corner, in double.
double distance_to_border(const Ray<float>& ray, const TracedTriangle<float>& triangle) {
  const Vec3d origin(ray.origin), direction(ray.direction);
  const Vec3d corners[] = {Vec3d(triangle.a), Vec3d(triangle.b), Vec3d(triangle.c)};
  const auto length = [](const Vec3d& v) { return std::sqrt(dot(v, v)); };
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    const Vec3d from = corners[i] - origin, edge = corners[(i + 1) % 3] - corners[i];
    const Vec3d across = cross(direction, edge);
    least = std::min(least, length(cross(from, direction)) / length(direction));
    if (length(across) > 0) least = std::min(least, std::abs(dot(from, across)) / length(across));
  }
  return least;
}

/// Embree has its own arithmetic, so at an edge it may take the neighbour, or let the ray through where ours does not,
/// or the other way round; nowhere else.
TEST(Accelerators, EmbreeFindsAnotherTriangleOnlyWithinFourUlpOfAnEdge) {
  if (!has_embree()) GTEST_SKIP() << "Embree is not compiled in";
  int differing = 0, rays_in_all = 0, only_ours = 0, only_embree = 0;
  std::uint64_t counted = 0;
  for (const Place& place : places) {
    for (unsigned seed = 81; seed < 81u + static_cast<unsigned>(test::trials(3)); ++seed) {
      SCOPED_TRACE(std::string(place.name) + ", seed " + std::to_string(seed));
      const Scene scene = aimed_scene(place, seed);
      Prepared prepared;
      Settings settings;
      const TraceInputs<float> bvh = make_trace_inputs<float>(scene, View{}, settings, prepared);
      settings.accelerator = Accelerator::embree;
      const TraceInputs<float> embree = make_trace_inputs<float>(scene, View{}, settings, prepared);
      ASSERT_NE(accelerator_as<EmbreeGeometry<float>>(embree.accelerator), nullptr);
      CountingRecorder expected_counts, found_counts;
      const Intersector<float, CountingRecorder> expected_by(bvh, expected_counts), found_by(embree, found_counts);
      const TracedGeometry<float>& geometry = *bvh.geometry;
      for (const Ray<float>& ray : aimed_rays(geometry, place, seed)) {
        ++rays_in_all;
        const Hit<float> expected = expected_by.nearest(ray), found = found_by.nearest(ray);
        if (same_bits(expected, found)) continue;
        ++differing;
        only_ours += expected.found() && !found.found() ? 1 : 0;
        only_embree += !expected.found() && found.found() ? 1 : 0;
        double reach = static_cast<double>(geometry.reach);
        for (int axis = 0; axis < 3; ++axis) reach = std::max(reach, static_cast<double>(std::abs(ray.origin[axis])));
        double least = std::numeric_limits<double>::infinity();
        for (const Hit<float>& hit : {expected, found})
          if (hit.found() && geometry.primitives[hit.primitive].kind == PrimitiveKind::triangle)
            least =
                std::min(least, distance_to_border(ray, geometry.triangles[geometry.primitives[hit.primitive].shape]));
        EXPECT_LE(least, 4 * std::numeric_limits<float>::epsilon() * reach);
      }
      counted += found_counts.counters[Counter::edge_rays];
    }
  }
  std::cout << rays_in_all << " rays aimed at edges and corners: " << differing << " find something else with Embree, "
            << only_ours << " of them nothing, " << only_embree << " something where ours finds nothing; " << counted
            << " counted as edge rays\n";
  EXPECT_GT(counted, 0u) << "rays aimed at edges must show that the arithmetic differs";
  EXPECT_LT(differing, rays_in_all / 20);
}

TEST(Accelerators, TheNaiveSlabTestLosesHits) {
  int lost = 0;
  for (const Place& place : places) {
    const Scene scene = aimed_scene(place, 81);
    Prepared prepared;
    Settings settings;
    settings.slab_test = SlabTest::naive;
    const TraceInputs<float> inputs = make_trace_inputs<float>(scene, View{}, settings, prepared);
    lost += differences(inputs, aimed_rays(*inputs.geometry, place, 81));
  }
  EXPECT_GT(lost, 0);
}

TEST(Accelerators, BoxesThatAreNotGrownLoseHits) {
  int lost = 0;
  for (const Place& place : places) {
    const Scene scene = aimed_scene(place, 81);
    Prepared prepared;
    TraceInputs<float> inputs = make_trace_inputs<float>(scene, View{}, {}, prepared);
    inputs.box_padding = 0;
    lost += differences(inputs, aimed_rays(*inputs.geometry, place, 81));
  }
  EXPECT_GT(lost, 0) << "the rays of these tests are too easy";
}

/// The usual mistake: a triangle stands only in the cell of its middle (stability: grid and octree borders).
TEST(Accelerators, AnOctreeOfMiddlesLosesHits) {
  const Scene scene = aimed_scene(places[0], 82);
  Prepared prepared;
  Settings settings;
  settings.accelerator = Accelerator::octree;
  TraceInputs<float> inputs = make_trace_inputs<float>(scene, View{}, settings, prepared);
  const TracedGeometry<float>& geometry = *inputs.geometry;
  Box<float> all;
  for (const Primitive& primitive : geometry.primitives) all.include(primitive_box(geometry, primitive));
  const auto count = static_cast<std::uint32_t>(geometry.primitives.size());
  inputs.accelerator = std::make_shared<const Octree<float>>(
      build_octree<float>(all, count, {}, [&](std::uint32_t primitive, const Box<float>& cell) {
        const Box<float> box = primitive_box(geometry, geometry.primitives[primitive]);
        const Vec3f middle = (box.low + box.high) * 0.5f;
        bool inside = true;
        for (int axis = 0; axis < 3; ++axis)
          inside = inside && middle[axis] >= cell.low[axis] && middle[axis] <= cell.high[axis];
        return inside;
      }));
  EXPECT_GT(differences(inputs, aimed_rays(geometry, places[0], 82)), 10);
}

}  // namespace
}  // namespace ps::accelerator_property_test
