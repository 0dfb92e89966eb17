#include "study/stability/aimed_rays.h"

#include "raytrace/triangle_moeller_trumbore.h"
#include "raytrace/triangle_watertight.h"

namespace ps::stability {

Aim::Aim(const ClosedSphere& mesh, std::uint32_t seed, double reach)
    : mesh_(mesh), around_(mesh.vertices.size()), random_(seed), reach_(reach) {
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i)
    for (const std::uint32_t vertex : mesh.triangles[i]) around_[vertex].push_back(i);
}

AimedRay Aim::next(AimAt what) {
  if (what == AimAt::vertex) {
    const auto vertex = static_cast<std::uint32_t>(random_.below(mesh_.vertices.size()));
    return towards(Vec3d(mesh_.vertices[vertex]), {vertex});
  }
  const auto& corners = mesh_.triangles[random_.below(mesh_.triangles.size())];
  if (what == AimAt::interior) {
    double u = random_.unit(), v = random_.unit();
    if (u + v > 1) u = 1 - u, v = 1 - v;
    const Vec3d a(mesh_.vertices[corners[0]]), b(mesh_.vertices[corners[1]]), c(mesh_.vertices[corners[2]]);
    return towards(a + (b - a) * u + (c - a) * v, {corners[0], corners[1], corners[2]});
  }
  const std::size_t side = random_.below(3);
  const std::uint32_t from = corners[side], to = corners[(side + 1) % 3];
  const Vec3d a(mesh_.vertices[from]), b(mesh_.vertices[to]);
  return towards(a + (b - a) * random_.unit(), {from, to});
}

AimedRay Aim::towards(const Vec3d& target, std::initializer_list<std::uint32_t> vertices) {
  const Vec3f from(random_.in_cube(reach_));
  AimedRay ray{from, Vec3f(target - Vec3d(from)), {}};
  for (const std::uint32_t vertex : vertices)
    for (const std::uint32_t triangle : around_[vertex])
      if (std::find(ray.candidates.begin(), ray.candidates.end(), triangle) == ray.candidates.end())
        ray.candidates.push_back(triangle);
  return ray;
}

std::vector<CrackRates> crack_rates(AimAt what, const std::vector<TriangleHits>& tests, const StabilityRun& run,
                                    double reach) {
  run.check();
  const ClosedSphere mesh = closed_sphere(160, 320, 2, {0, 0, 0});
  Aim aim(mesh, run.seed, reach);
  const int rays = run.count(1000000);
  std::vector<CrackRates> rates(tests.size());
  for (int i = 0; i < rays; ++i) {
    if (i % 65536 == 0) run.check();
    const AimedRay ray = aim.next(what);
    for (std::size_t k = 0; k < tests.size(); ++k) {
      int hits = 0;
      for (const std::uint32_t triangle : ray.candidates) hits += tests[k](ray, mesh.triangle(triangle)) ? 1 : 0;
      rates[k].misses += hits == 0 ? 1 : 0;
      rates[k].doubles += hits > 1 ? 1 : 0;
    }
  }
  for (CrackRates& rate : rates) rate = {per_million(rate.misses, rays), per_million(rate.doubles, rays)};
  return rates;
}

void add_cracks(Rows& rows, double knob, const std::string& series, const CrackRates& naive, const CrackRates& robust) {
  rows.push_back({knob, series + ", misses", naive.misses, robust.misses, "per million rays"});
  rows.push_back({knob, series + ", double hits", naive.doubles, robust.doubles, "per million rays"});
}

bool watertight_hits(const AimedRay& ray, const TracedTriangle<float>& triangle) {
  const auto result =
      triangle_watertight<float>(ray.origin, Shear<float>(ray.direction), triangle, TriangleGuard::none);
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
