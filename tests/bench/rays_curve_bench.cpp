// How the time per ray grows with the number of triangles: about with its logarithm.

#include <fmt/core.h>

#include "bench/bench.h"
#include "bench/meshes.h"
#include "bench/rays/our_rays.h"

namespace ps::bench {
namespace {

struct RayCurveSubject {
  OurRays ours;
  std::vector<BenchRay> rays;
  std::vector<BenchHit> hits;
};

Job curve_job(int triangles) {
  const std::shared_ptr<const Mesh> mesh = sphere_of(triangles);
  const std::shared_ptr<RayCurveSubject> subject(
      new RayCurveSubject{OurRays(mesh_scene(mesh), Settings{}, std::make_shared<Prepared>()),
                          primary_rays(framed_view(*mesh, 640, 480)),
                          {}});
  subject->hits.resize(subject->rays.size());
  Job job;
  job.ours = [subject] { subject->ours.nearest(subject->rays, subject->hits); };
  job.amount = static_cast<double>(subject->rays.size()) * 1e-6;
  job.size = static_cast<double>(mesh->triangles.size());
  job.note =
      fmt::format("{} triangles, {:.0f} bytes for each", mesh->triangles.size(), subject->ours.bytes_per_triangle());
  return job;
}

}  // namespace

Benches rays_curve_benches() {
  struct Size {
    const char* name;
    int triangles;
  };
  Benches benches;
  for (const auto& [name, triangles] :
       {Size{"1k", 1000}, {"10k", 10000}, {"100k", 100000}, {"1M", 1000000}, {"4M", 4000000}})
    benches.push_back(
        {fmt::format("curve/rays/{}", name), "Mray/s", "", [triangles = triangles] { return curve_job(triangles); }});
  return benches;
}

}  // namespace ps::bench
