#include <algorithm>
#include <cmath>
#include <numeric>

#include "raytrace/clear/triangle_watertight.h"
#include "study/stability/aimed_rays.h"
#include "study/stability/triangle_methods.h"

namespace ps::stability::triangle_cracks {
namespace {

std::string name_of(AimAt what) {
  return what == AimAt::interior ? "inside triangles" : what == AimAt::edge ? "at edges" : "at vertices";
}

/// Rays between floats at the centre of a far sphere of 9,800 triangles and floats at its edges: they lie so coarsely
/// out there that a test's differences and most of its products are exact, and that some triangles are flat.
void add_far_sphere(Rows& rows, const StabilityRun& run) {
  run.check();
  const ClosedSphere mesh = closed_sphere(50, 100, 2, far_centre);
  std::vector<std::uint32_t> all(mesh.triangles.size());
  std::iota(all.begin(), all.end(), 0u);
  const auto without_area = std::count_if(all.begin(), all.end(), [&](std::uint32_t i) {
    const TracedTriangle<float> t = mesh.triangle(i);
    return cross(Vec3d(t.b) - Vec3d(t.a), Vec3d(t.c) - Vec3d(t.a)) == Vec3d(0);  // exact: few bits of each differ
  });
  rows.add(32, "far sphere, triangles without an area", static_cast<double>(without_area), std::nan(""),
           "of 9,800 triangles");
  constexpr int rays = 40000;
  Random random(run.seed);
  double naive = 0, robust = 0;
  const TriangleHits moeller_trumbore = moeller_trumbore_hits<float>(0, 0);
  for (int i = 0; i < rays; ++i) {
    if (i % 1024 == 0) run.check();
    const std::size_t aimed_at = random.below(mesh.triangles.size()), side = random.below(3);
    const auto& corners = mesh.triangles[aimed_at];
    const Vec3d a(mesh.vertices[corners[side]]), b(mesh.vertices[corners[(side + 1) % 3]]);
    const Vec3f target(a + (b - a) * random.unit());
    const Vec3f origin = Vec3f(far_centre) + Vec3f(random.in_cube(1));
    const AimedRay ray{origin, target - origin, Shear<float>(target - origin), {}};
    const auto missed = [&](const TriangleHits& test) {
      const auto hits = [&](std::uint32_t k) { return test(ray, mesh.triangle(k)); };
      return !hits(static_cast<std::uint32_t>(aimed_at)) && std::none_of(all.begin(), all.end(), hits);
    };
    naive += missed(moeller_trumbore) ? 1 : 0;
    robust += missed(watertight_hits) ? 1 : 0;
  }
  rows.add(32, "far sphere, at edges, misses", naive, robust, "of 40,000 rays");
}

void measure_edge_cracks(const StabilityRun& run, Rows& rows) {
  for (const AimAt what : {AimAt::edge, AimAt::vertex, AimAt::interior}) {
    const std::string where = name_of(what);
    std::vector<TriangleHits> tests{watertight_hits, moeller_trumbore_hits<float>(0, 0),
                                    moeller_trumbore_hits<double>(0, 0), cgpp_hits, float_only_hits};
    if (what == AimAt::edge) tests.insert(tests.end(), {plane_barycentric_hits, plane_cross_products_hits});
    const std::vector<CrackRates> rates = crack_rates(what, tests, run);
    add_cracks(rows, 32, where, rates[1], rates[0]);
    add_cracks(rows, 64, where, rates[2], rates[0]);
    add_cracks(rows, 32, "CGPP's epsilons, " + where, rates[3], rates[0]);
    add_cracks(rows, 32, "Woop in float alone, " + where, rates[4], rates[0]);
    if (what != AimAt::edge) continue;
    add_cracks(rows, 32, "triangle-test = barycentric, " + where, rates[5], rates[0]);
    add_cracks(rows, 32, "triangle-test = cross-products, " + where, rates[6], rates[0]);
  }
  add_far_sphere(rows, run);
}

void measure_tolerance(const StabilityRun& run, Rows& rows) {
  const auto add = [&](AimAt what, const std::vector<float>& tolerances) {
    std::vector<TriangleHits> tests{watertight_hits};
    for (const float tolerance : tolerances) tests.push_back(moeller_trumbore_hits<float>(0, tolerance));
    const std::vector<CrackRates> rates = crack_rates(what, tests, run);
    for (std::size_t i = 0; i < tolerances.size(); ++i)
      add_cracks(rows, tolerances[i], name_of(what), rates[i + 1], rates[0]);
  };
  add(AimAt::edge, {0.0f, 1e-7f, 1e-6f, 1e-5f, 1e-4f});
  add(AimAt::vertex, {0.0f, 1e-6f, 1e-5f, 1e-4f});
  add(AimAt::interior, {1e-5f});
}

/// Rays of length 1 at the edges of a sphere of triangles, from its centre: the percentage that escapes each test.
std::vector<double> escaped(double radius, const std::vector<TriangleHits>& tests, const StabilityRun& run) {
  run.check();
  const ClosedSphere mesh = closed_sphere(160, 320, radius, {0, 0, 0});
  Aim aim(mesh, run.seed, radius);
  const int rays = run.count(200000, 20000);
  std::vector<double> misses(tests.size());
  for (int i = 0; i < rays; ++i) {
    AimedRay ray = aim.next(AimAt::edge);
    ray.direction /= std::sqrt(dot(ray.direction, ray.direction));
    ray.shear = Shear<float>(ray.direction);
    for (std::size_t k = 0; k < tests.size(); ++k) {
      const bool met = std::any_of(ray.candidates.begin(), ray.candidates.end(),
                                   [&](std::uint32_t triangle) { return tests[k](ray, mesh.triangle(triangle)); });
      misses[k] += met ? 0 : 1;
    }
  }
  for (double& count : misses) count = percent(count, rays);
  return misses;
}

void measure_determinant(const StabilityRun& run, Rows& rows) {
  const std::vector<TriangleHits> tests{watertight_hits, moeller_trumbore_hits<float>(1e-7f, 1e-10f),
                                        moeller_trumbore_hits<float>(1e-8f, 1e-10f)};
  for (const double radius : {2.0, 0.05, 0.02, 0.01, 0.001}) {
    const std::vector<double> lost = escaped(radius, tests, run);
    rows.add(radius, "epsilon 1e-7", lost[1], lost[0], "% of rays lost");
    rows.add(radius, "epsilon 1e-8", lost[2], lost[0], "% of rays lost");
  }
}

}  // namespace

extern const StabilityExperiment triangle_edge_cracks{
    .key = "triangle-edge-cracks",
    .place = {Subject::rays, 90},
    .set_up = SetUp::reproduction,
    .title = "Cracks along triangle edges",
    .keywords = "watertight, holes, seams, Moeller-Trumbore, Möller-Trumbore, shared edge",
    .knob = "precision (bits of a floating-point number)",
    .naive = "Moeller-Trumbore (triangle-test = moeller-trumbore)",
    .robust = "watertight (Woop; triangle-test = watertight)",
    .explanation = "Each triangle computes its shared edge from its own vertex and differences, so two neighbours may "
                   "both place a ray beyond it. The watertight test computes the same numbers on both sides.",
    .safe = "Nowhere for rays that are aimed at edges; random rays meet three cracks in a million.",
    .window = nowhere_safe,
    .series = {{.names = "at edges, misses|*misses",
                .title = "rays that slip through",
                .unit = "per million",
                .cases = {{32, "float"}, {64, "double"}}},
               {.names = "*double hits",
                .title = "rays that hit two triangles",
                .unit = "per million",
                .cases = {{32, "float"}, {64, "double"}}},
               {.names = "far sphere, triangles without an area",
                .title = "triangles without an area",
                .unit = "of 9,800"},
               {.names = "far sphere, at edges, misses",
                .title = "rays that slip through the far sphere",
                .unit = "of 40,000"}},
    .add_rows = measure_edge_cracks};

extern const StabilityExperiment mt_tolerance{
    .key = "mt-tolerance",
    .place = {Subject::rays, 110},
    .set_up = SetUp::reproduction,
    .title = "A tolerance instead of a watertight test",
    .keywords = "watertight, epsilon, Moeller-Trumbore, Möller-Trumbore, double hit, cracks",
    .knob = "tolerance of the barycentric weights",
    .naive = "Moeller-Trumbore that accepts weights >= -tolerance",
    .robust = "watertight (Woop)",
    .explanation = "Every triangle grows a little, so cracks close. Rays at an edge then hit both triangles, which is "
                   "wrong for transparency and for counts that decide between inside and outside.",
    .safe = "Nowhere: 1e-4 leaves ten misses in a million rays at edges and makes all others hit twice.",
    .window = nowhere_safe,
    .series = {{.names = "at edges, misses|*misses", .title = "rays that slip through", .unit = "per million"},
               {.names = "*double hits", .title = "rays that hit two triangles", .unit = "per million"}},
    .add_rows = measure_tolerance};

extern const StabilityExperiment absolute_det_epsilon{
    .key = "absolute-det-epsilon",
    .place = {Subject::rays, 120},
    .title = "An absolute epsilon for determinants",
    .keywords = "determinant, small triangles, tolerance, scale, Moeller-Trumbore",
    .knob = "radius of the mesh (world units)",
    .naive = "Moeller-Trumbore that rejects |det| <= epsilon as parallel (triangle-epsilon)",
    .robust = "watertight (Woop), which rejects det = 0 alone",
    .explanation = "For a ray of length 1 the determinant is at most twice the triangle's area, so it falls with the "
                   "square of the scale. In small units every triangle is rejected.",
    .safe = "Triangles with areas far above the epsilon; the losses that remain are cracks at edges.",
    .window = {1, everywhere},
    .series = {{.names = "epsilon 1e-7|*", .title = "rays that are lost", .unit = "%"}},
    .add_rows = measure_determinant};

}  // namespace ps::stability::triangle_cracks
