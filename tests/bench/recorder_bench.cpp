// That the silent recorder costs nothing: the walk through a tree of boxes as the ray tracer has it, with Silent,
// beside the same walk written out without a recorder.

#include "bench/bench.h"
#include "bench/meshes.h"
#include "bench/rays/ray_set.h"
#include "raytrace/base/trace_inputs.h"
#include "raytrace/clear/triangle_moeller_trumbore.h"

namespace ps::bench {
namespace {

/// for_each_candidate(Bvh...) of accel/bvh.h, line for line, without its recorder.
template <class Visit>
void walk_without_recorder(const Bvh<float>& bvh, const SlabRay<float>& ray, const float& limit, Visit&& visit) {
  struct Waiting {
    std::uint32_t node;
    int level;
    float near;
  };
  if (bvh.nodes.empty()) return;
  std::array<Waiting, bvh_max_depth + 1> stack;
  int waiting = 0;
  Waiting current{0, 0, 0};
  while (true) {
    const BvhNode<float>& node = bvh.nodes[current.node];
    for (std::uint32_t i = 0; i < node.count; ++i)
      if (visit(bvh.order[node.first + i])) return;
    if (node.count == 0) {
      const std::uint32_t left = node.first;
      const std::uint32_t right = left + 1;
      const SlabRange<float> left_range = slab_test(ray, bvh.nodes[left].box, limit);
      const SlabRange<float> right_range = slab_test(ray, bvh.nodes[right].box, limit);
      const int level = current.level + 1;
      const Waiting left_entry{left, level, left_range.near};
      const Waiting right_entry{right, level, right_range.near};
      if (left_range.hit() && right_range.hit()) {
        const bool left_first = left_range.near <= right_range.near;
        stack[static_cast<std::size_t>(waiting++)] = left_first ? right_entry : left_entry;
        current = left_first ? left_entry : right_entry;
        continue;
      }
      if (left_range.hit() || right_range.hit()) {
        current = left_range.hit() ? left_entry : right_entry;
        continue;
      }
    }
    do {
      if (waiting == 0) return;
      current = stack[static_cast<std::size_t>(--waiting)];
    } while (current.near > limit);
  }
}

struct RecorderSubject {
  Prepared prepared;
  TraceInputs<float> inputs;
  std::vector<BenchRay> rays;
  std::vector<BenchHit> with, without;

  /// The nearest triangle of each ray; `walk(slabs, limit, visit)` goes through the tree.
  template <class Walk>
  void find(std::vector<BenchHit>& hits, Walk&& walk) const {
    const TracedGeometry<float>& geometry = *inputs.geometry;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      BenchHit hit{no_hit, rays[i].t_max};
      const auto visit = [&](std::uint32_t primitive) {
        const auto result =
            triangle_moeller_trumbore(rays[i].origin, rays[i].direction, geometry.triangles[primitive], 0.0f);
        if (result.verdict == TriangleVerdict::inside && result.t > 0 && result.t < hit.t) hit = {primitive, result.t};
        return false;
      };
      walk(SlabRay<float>(rays[i].origin, rays[i].direction, 0), hit.t, visit);
      hits[i] = hit;
    }
  }
};

Job silent_job() {
  const std::shared_ptr<const Mesh> mesh = bench_mesh("teapot");
  const auto subject = std::make_shared<RecorderSubject>();
  const View view = framed_view(*mesh, 512, 384);
  subject->inputs = make_trace_inputs<float>(mesh_scene(mesh), view, Settings{}, subject->prepared);
  subject->rays = primary_rays(view);
  subject->with.resize(subject->rays.size());
  subject->without.resize(subject->rays.size());
  Job job;
  job.ours = [subject] {
    subject->find(subject->with, [&](const SlabRay<float>& slabs, const float& limit, auto& visit) {
      Silent silent;
      for_each_candidate(accelerator_as<BvhOnDemand<float>>(subject->inputs.accelerator)->tree(), slabs, limit, visit,
                         silent);
    });
  };
  job.yardstick = [subject] {
    subject->find(subject->without, [&](const SlabRay<float>& slabs, const float& limit, auto& visit) {
      walk_without_recorder(accelerator_as<BvhOnDemand<float>>(subject->inputs.accelerator)->tree(), slabs, limit,
                            visit);
    });
  };
  job.check = [job, subject]() -> std::string {
    job.ours();
    job.yardstick();
    const auto same = [](const BenchHit& a, const BenchHit& b) { return a.triangle == b.triangle && a.t == b.t; };
    const bool equal = std::equal(subject->with.begin(), subject->with.end(), subject->without.begin(), same);
    return equal ? "" : "the walks find different triangles";
  };
  job.amount = static_cast<double>(subject->rays.size()) * 1e-6;
  job.note = "1.00 = the silent recorder costs nothing";
  return job;
}

}  // namespace

Benches recorder_benches() { return {{"recorder/silent/teapot", "Mray/s", "no-recorder", silent_job}}; }

}  // namespace ps::bench
