// Our ray queries beside Embree's: single rays on one thread, and building the tree.

#include <fmt/core.h>

#include "bench/bench.h"
#include "bench/embree/embree_scene.h"
#include "bench/meshes.h"
#include "bench/rays/our_rays.h"

namespace ps::bench {
namespace {

constexpr int build_threads = 2;
constexpr std::size_t most_secondary_rays = 200000;
enum class RayKinds { primary, shadow, random };
enum class EmbreeQueries { single, packets };

/// A mesh with its rays, shared by the benches of that mesh, which follow each other.
struct Subject {
  std::string name;
  std::shared_ptr<const Mesh> mesh;
  Scene scene;
  std::shared_ptr<Prepared> prepared;  ///< our accelerator
  std::shared_ptr<const EmbreeScene> fast, robust;
  std::vector<BenchRay> primary, shadow, random;
};

/// Every n-th, so that at most `most` remain.
std::vector<BenchRay> thinned(const std::vector<BenchRay>& rays, std::size_t most) {
  std::vector<BenchRay> result;
  const std::size_t step = (rays.size() + most - 1) / most;
  for (std::size_t i = 0; i < rays.size(); i += step) result.push_back(rays[i]);
  return result;
}

std::shared_ptr<const Subject> subject(const std::string& name) {
  static std::shared_ptr<const Subject> last;  // only one is kept: a million triangles are large
  if (last && last->name == name) return last;
  last.reset();
  auto made = std::make_shared<Subject>();
  made->name = name;
  made->mesh = bench_mesh(name);
  made->scene = mesh_scene(made->mesh);
  made->primary = primary_rays(framed_view(*made->mesh, 1024, 768));
  made->prepared = std::make_shared<Prepared>();
  made->fast = std::make_shared<EmbreeScene>(*made->mesh, EmbreeMode::fast, build_threads);
  made->robust = std::make_shared<EmbreeScene>(*made->mesh, EmbreeMode::robust, build_threads);
  const SurfacePoints surface =
      surface_points(*made->mesh, made->primary, [&](auto rays, auto hits) { made->robust->nearest(rays, hits); });
  made->shadow = thinned(shadow_rays(surface, made->scene.lights->back().position), most_secondary_rays);
  made->random = thinned(random_rays(surface), most_secondary_rays);
  last = made;
  return last;
}

Settings settings_for(EmbreeMode mode) {
  Settings settings;
  settings.triangle_test = mode == EmbreeMode::robust ? TriangleTest::watertight : TriangleTest::moeller_trumbore;
  return settings;
}

struct Sides {
  OurRays ours;
  std::shared_ptr<const EmbreeScene> embree;
  std::shared_ptr<const Subject> owner;  ///< of the rays
  std::span<const BenchRay> rays;
  std::vector<BenchHit> our_hits, embree_hits;
};

Job query_job(const std::string& mesh, RayKinds kind, EmbreeMode mode, EmbreeQueries queries = EmbreeQueries::single) {
  const auto on = subject(mesh);
  const std::vector<BenchRay>& rays = kind == RayKinds::primary  ? on->primary
                                      : kind == RayKinds::shadow ? on->shadow
                                                                 : on->random;
  const std::shared_ptr<Sides> sides(new Sides{OurRays(on->scene, settings_for(mode), on->prepared),
                                               mode == EmbreeMode::fast ? on->fast : on->robust,
                                               on,
                                               rays,
                                               {},
                                               {}});
  sides->our_hits.resize(rays.size());
  sides->embree_hits.resize(rays.size());
  Job job;
  if (kind == RayKinds::shadow) {
    job.ours = [sides] { sides->ours.any(sides->rays, sides->our_hits); };
    job.yardstick = [sides] { sides->embree->any(sides->rays, sides->embree_hits); };
  } else if (queries == EmbreeQueries::packets) {
    job.ours = [sides] { sides->ours.nearest_together(sides->rays, sides->our_hits); };
    job.yardstick = [sides] { sides->embree->nearest_in_packets(sides->rays, sides->embree_hits); };
  } else {
    job.ours = [sides] { sides->ours.nearest(sides->rays, sides->our_hits); };
    job.yardstick = [sides] { sides->embree->nearest(sides->rays, sides->embree_hits); };
  }
  job.ours();
  job.yardstick();
  job.check = [difference = compare_hits(sides->our_hits, sides->embree_hits, job.note)] { return difference; };
  job.amount = static_cast<double>(rays.size()) * 1e-6;
  return job;
}

Job build_job(const std::string& mesh) {
  const auto on = subject(mesh);
  const auto ours = std::make_shared<OurRays>(on->scene, Settings{}, on->prepared);
  const auto embree = std::make_shared<EmbreeScene>(*on->mesh, EmbreeMode::fast, build_threads);
  Job job;
  job.ours = [ours] { ours->rebuild(); };
  job.yardstick = [embree] { embree->rebuild(); };
  job.note = fmt::format("{} triangles, ours keeps {:.0f} bytes for each", on->mesh->triangles.size(),
                         ours->bytes_per_triangle());
  return job;
}

}  // namespace

Benches embree_benches() {
  struct Kind {
    const char* name;
    RayKinds kind;
  };
  Benches benches;
  for (const char* name : {"teapot", "200k", "1M"}) {
    const std::string mesh = name;
    for (const auto& [kind_name, kind] :
         {Kind{"primary", RayKinds::primary}, {"shadow", RayKinds::shadow}, {"random", RayKinds::random}}) {
      benches.push_back({fmt::format("rays/{}/{}/moeller-trumbore", kind_name, mesh), "Mray/s", "embree",
                         [mesh, kind = kind] { return query_job(mesh, kind, EmbreeMode::fast); }});
      benches.push_back({fmt::format("rays/{}/{}/watertight", kind_name, mesh), "Mray/s", "embree-robust",
                         [mesh, kind = kind] { return query_job(mesh, kind, EmbreeMode::robust); }});
    }
    benches.push_back({"rays/coherent/" + mesh, "Mray/s", "embree-16-wide", [mesh] {
                         return query_job(mesh, RayKinds::primary, EmbreeMode::fast, EmbreeQueries::packets);
                       }});
    benches.push_back({"rays/build/" + mesh, "ms", "embree", [mesh] { return build_job(mesh); }});
  }
  return benches;
}

}  // namespace ps::bench
