#include "study/stability/aimed_rays.h"

#include "raytrace/clear/triangle_moeller_trumbore.h"

namespace ps::stability {

Aim::Aim(const ClosedSphere& mesh, std::uint32_t seed, double side)
    : mesh_(mesh), around_(mesh.vertices.size()), random_(seed), half_side_(side / 2) {
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i)
    for (const std::uint32_t vertex : mesh.triangles[i]) around_[vertex].push_back(i);
  for (const auto& vertices : mesh.triangles) {
    const std::size_t first = neighbours_.size();
    first_neighbour_.push_back(first);
    for (const std::uint32_t vertex : vertices)
      for (const std::uint32_t triangle : around_[vertex]) {
        const auto begin = neighbours_.begin() + static_cast<std::ptrdiff_t>(first);
        if (std::find(begin, neighbours_.end(), triangle) == neighbours_.end()) neighbours_.push_back(triangle);
      }
  }
  first_neighbour_.push_back(neighbours_.size());
}

AimedRay Aim::next(AimAt what) {
  if (what == AimAt::vertex) {
    const std::size_t vertex = random_.below(mesh_.vertices.size());
    return towards(Vec3d(mesh_.vertices[vertex]), around_[vertex]);
  }
  const std::size_t triangle = random_.below(mesh_.triangles.size());
  const auto vertex = [&](std::size_t k) { return Vec3d(mesh_.vertices[mesh_.triangles[triangle][k]]); };
  if (what == AimAt::interior) {
    double u = random_.unit(), v = random_.unit();
    if (u + v > 1) u = 1 - u, v = 1 - v;
    const Vec3d a = vertex(0), b = vertex(1), c = vertex(2);
    return towards(a + (b - a) * u + (c - a) * v, neighbours(triangle));
  }
  const std::size_t side = random_.below(3);
  const Vec3d from = vertex(side), to = vertex((side + 1) % 3);
  return towards(from + (to - from) * random_.unit(), neighbours(triangle));
}

AimedRay Aim::towards(const Vec3d& target, std::span<const std::uint32_t> candidates) {
  const Vec3f from(random_.in_cube(half_side_));
  const Vec3f direction(target - Vec3d(from));
  return {from, direction, Shear<float>(direction), candidates};
}

/// The rarer the failures, the more rays are needed to count them.
static int rays_aimed_at(AimAt what) {
  switch (what) {
  case AimAt::interior:
    return 2500000;
  case AimAt::edge:
    return 600000;
  case AimAt::vertex:
    return 100000;
  }
  return 0;
}

std::vector<CrackRates> crack_rates(AimAt what, const std::vector<TriangleHits>& tests, const StabilityRun& run) {
  run.check();
  const ClosedSphere mesh = closed_sphere(160, 320, 2, {0, 0, 0});
  Aim aim(mesh, run.seed, 2);
  const int rays = run.count(rays_aimed_at(what));
  std::vector<CrackRates> rates(tests.size());
  std::vector<TracedTriangle<float>> around;
  for (int i = 0; i < rays; ++i) {
    if (i % 65536 == 0) run.check();
    const AimedRay ray = aim.next(what);
    around.clear();
    for (const std::uint32_t triangle : ray.candidates) around.push_back(mesh.triangle(triangle));
    for (std::size_t k = 0; k < tests.size(); ++k) {
      int hits = 0;
      for (const TracedTriangle<float>& triangle : around) hits += tests[k](ray, triangle) ? 1 : 0;
      rates[k].misses += hits == 0 ? 1 : 0;
      rates[k].doubles += hits > 1 ? 1 : 0;
    }
  }
  for (CrackRates& rate : rates) rate = {per_million(rate.misses, rays), per_million(rate.doubles, rays)};
  return rates;
}

void add_cracks(Rows& rows, double knob, const std::string& series, const CrackRates& naive, const CrackRates& robust) {
  rows.add(knob, series + ", misses", naive.misses, robust.misses, "per million rays");
  rows.add(knob, series + ", double hits", naive.doubles, robust.doubles, "per million rays");
}

bool watertight_hits(const AimedRay& ray, const TracedTriangle<float>& triangle) {
  const auto result = triangle_watertight<float>(ray.origin, ray.shear, triangle, TriangleGuard::none);
  return result.verdict == TriangleVerdict::inside && result.t > 0;
}

template <class Real>
TriangleHits moeller_trumbore_hits(Real epsilon, Real tolerance) {
  return [=](const AimedRay& ray, const TracedTriangle<float>& t) {
    const TracedTriangle<Real> triangle{Vec3<Real>(t.a), Vec3<Real>(t.b), Vec3<Real>(t.c)};
    const auto result =
        triangle_moeller_trumbore<Real>(Vec3<Real>(ray.origin), Vec3<Real>(ray.direction), triangle, epsilon);
    if (result.verdict == TriangleVerdict::parallel || !(result.t > 0)) return false;
    return result.weights[0] >= -tolerance && result.weights[1] >= -tolerance && result.weights[2] >= -tolerance;
  };
}

template TriangleHits moeller_trumbore_hits<float>(float, float);
template TriangleHits moeller_trumbore_hits<double>(double, double);

}  // namespace ps::stability
