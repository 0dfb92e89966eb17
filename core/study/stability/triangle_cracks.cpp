#include "study/stability/aimed_rays.h"

namespace ps::stability {
namespace {

void add(Rows& rows, double knob, const std::string& series, const CrackRates& naive, const CrackRates& robust) {
  rows.push_back({knob, series + ", misses", naive.misses, robust.misses, "per million rays"});
  rows.push_back({knob, series + ", double hits", naive.doubles, robust.doubles, "per million rays"});
}

std::vector<StabilityRow> measure_edge_cracks(const StabilityRun& run) {
  Rows rows(run);
  for (const AimAt what : {AimAt::edge, AimAt::vertex}) {
    const std::string where = what == AimAt::edge ? "at edges" : "at vertices";
    const CrackRates robust = crack_rates(what, watertight_hits, run);
    add(rows, 32, where, crack_rates(what, moeller_trumbore_hits<float>(0, 0), run), robust);
    add(rows, 64, where, crack_rates(what, moeller_trumbore_hits<double>(0, 0), run), robust);
  }
  return rows;
}

std::vector<StabilityRow> measure_tolerance(const StabilityRun& run) {
  Rows rows(run);
  const CrackRates robust = crack_rates(AimAt::edge, watertight_hits, run);
  for (const float tolerance : {0.0f, 1e-7f, 1e-6f, 1e-5f, 1e-4f})
    add(rows, tolerance, "at edges", crack_rates(AimAt::edge, moeller_trumbore_hits<float>(0, tolerance), run), robust);
  return rows;
}

/// Side of the ray's line on which each edge passes, by Pluecker coordinates.
bool pluecker(const AimedRay& ray, const TracedTriangle<float>& triangle) {
  const Vec3f a = triangle.a - ray.origin, b = triangle.b - ray.origin, c = triangle.c - ray.origin;
  const auto side = [&](const Vec3f& p, const Vec3f& q) { return dot(cross(p - q, p + q), ray.direction); };
  const float u = side(c, b), v = side(a, c), w = side(b, a);
  return (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
}

std::vector<StabilityRow> measure_pluecker(const StabilityRun& run) {
  Rows rows(run);
  for (const AimAt what : {AimAt::edge, AimAt::vertex})
    add(rows, what == AimAt::edge ? 0 : 1, what == AimAt::edge ? "at edges" : "at vertices",
        crack_rates(what, pluecker, run), crack_rates(what, watertight_hits, run));
  return rows;
}

/// Rays of length 1 at the edges of a sphere of triangles, from its middle: how many leave it.
double escaped(double radius, const TriangleHits& test, const StabilityRun& run) {
  run.check();
  const ClosedSphere mesh = closed_sphere(160, 320, radius, {0, 0, 0});
  Aim aim(mesh, run.seed, radius / 4);
  const int rays = run.count(200000, 20000);
  int misses = 0;
  for (int i = 0; i < rays; ++i) {
    AimedRay ray = aim.next(AimAt::edge);
    ray.direction /= std::sqrt(dot(ray.direction, ray.direction));
    const bool met = std::any_of(ray.candidates.begin(), ray.candidates.end(),
                                 [&](std::uint32_t triangle) { return test(ray, mesh.triangle(triangle)); });
    misses += met ? 0 : 1;
  }
  return percent(misses, rays);
}

std::vector<StabilityRow> measure_determinant(const StabilityRun& run) {
  Rows rows(run);
  for (const double radius : {2.0, 0.05, 0.02, 0.01, 0.001}) {
    const double robust = escaped(radius, watertight_hits, run);
    for (const auto& [epsilon, name] : {std::pair{1e-7f, "epsilon 1e-7"}, {1e-8f, "epsilon 1e-8"}})
      rows.push_back({radius, name, escaped(radius, moeller_trumbore_hits<float>(epsilon, 1e-10f), run), robust,
                      "% of rays lost"});
  }
  return rows;
}

}  // namespace

const StabilityExperiment triangle_edge_cracks{
    .key = "triangle-edge-cracks",
    .title = "Cracks along triangle edges",
    .knob = "bits of a number",
    .naive = "Moeller-Trumbore",
    .robust = "watertight (Woop)",
    .explanation = "Each triangle computes a shared edge from numbers of its own, so two neighbours may both place a "
                   "ray beyond it. The watertight test computes it from the same numbers on both sides.",
    .safe = "Nowhere for rays that are aimed at edges; random rays see three cracks in a million.",
    .window = nowhere_safe,
    .measure = measure_edge_cracks};

const StabilityExperiment mt_tolerance{
    .key = "mt-tolerance",
    .title = "A tolerance instead of a watertight test",
    .knob = "tolerance of the weights",
    .naive = "Moeller-Trumbore, weights >= -tolerance",
    .robust = "watertight (Woop)",
    .explanation = "Every triangle grows a little, so cracks close. What falls on the seam is then hit twice, which "
                   "counts in transparency and in tests of inside and outside.",
    .safe = "Nowhere: 1e-4 leaves a dozen misses and hits everything else twice.",
    .window = nowhere_safe,
    .measure = measure_tolerance};

const StabilityExperiment plucker_vertices{
    .key = "plucker-vertices",
    .title = "Pluecker coordinates at vertices",
    .knob = "0 = at edges, 1 = at vertices",
    .naive = "Pluecker coordinates",
    .robust = "watertight (Woop)",
    .explanation = "Along an edge both neighbours compute the same number with opposite signs. Around a vertex several "
                   "edges meet whose roundings have nothing to do with each other.",
    .safe = "Edges, not vertices.",
    .window = {0, 0},
    .measure = measure_pluecker};

const StabilityExperiment absolute_det_epsilon{
    .key = "absolute-det-epsilon",
    .title = "An absolute epsilon for determinants",
    .knob = "radius of the mesh",
    .naive = "|det| <= epsilon is parallel",
    .robust = "watertight (Woop), det != 0",
    .explanation = "The determinant is about twice the triangle's area, so it falls with the square of the scale. In "
                   "small units every triangle is smaller than the epsilon.",
    .safe = "Triangles with areas far above the epsilon; what is lost then are the cracks at edges.",
    .window = {1, everywhere},
    .measure = measure_determinant};

}  // namespace ps::stability
