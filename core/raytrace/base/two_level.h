#pragma once
#include <vector>

#include "accel/bvh.h"
#include "accel/candidate_ray.h"
#include "accel/into_model.h"
#include "raytrace/base/geometry.h"

namespace ps {

/// Two levels of trees: one over the triangles of each mesh, in the mesh's own space and kept once, and one over what
/// is in the world: instances, and everything that has no mesh.
template <class Real>
struct TwoLevel {
  std::vector<Bvh<Real>> models;  ///< for each of TracedGeometry::meshes; its order holds the mesh's triangles
  std::vector<IntoModel> into;    ///< for each of TracedGeometry::instances
  Bvh<Real> top;                  ///< its order holds indices into TracedGeometry::numbers
  int top_levels = 1;             ///< levels of `top`: those of the models' trees are counted on from there

  std::size_t heap_bytes() const { return owned_bytes(models, into, top); }
};

template <class Real>
std::shared_ptr<const TwoLevel<Real>> two_level(const Scene& scene, const TracedGeometry<Real>& geometry,
                                                Prepared& prepared);

/// Reports the boxes of a model's tree as those of an instance.
template <class Recorder>
struct ModelRecorder {
  Recorder& recorder;
  int object = -1;
  int first_level = 0;
  void count(Counter counter, std::uint64_t n = 1) { recorder.count(counter, n); }
  template <class Make>
  void event(Make&& make) {
    recorder.event([&] {
      NodeEvent event = make();
      event.object = object;
      event.level += first_level;
      return event;
    });
  }
};

/// The accelerator interface (accel/none.h), but for visit(number, primitive) -> bool. The ray goes through each
/// model's tree as the model sees it; its triangles are visited in the world.
template <class Real, class Visit, class Recorder>
void for_each_candidate(const TwoLevel<Real>& trees, const TracedGeometry<Real>& geometry,
                        const CandidateRay<Real>& ray, const Real& limit, Visit&& visit, Recorder& recorder) {
  const SlabRay<Real> world = ray.slabs();
  /// Returns whether a visit ended the search.
  const auto visit_instance = [&](std::uint32_t index) {
    const PlacedInstance& placed = geometry.instances[index];
    const Box<Real> box{Vec3<Real>(placed.box.low), Vec3<Real>(placed.box.high)};
    const bool entered = slab_test(world, box, limit).hit();
    recorder.count(Counter::node_visits);
    recorder.event([&] {
      const int node = static_cast<int>(trees.top.nodes.size()) + static_cast<int>(index);
      return NodeEvent{node, trees.top_levels, placed.box.low, placed.box.high, entered};
    });
    if (!entered) return false;
    bool ended = false;
    const auto visit_triangle = [&](std::uint32_t triangle) {
      ended = visit(placed.first + triangle, placed_primitive(geometry, index, triangle));
      return ended;
    };
    const auto slabs = slabs_in_model(trees.into[index], ray.origin, ray.direction, ray.pad, ray.form);
    if (slabs) {
      ModelRecorder<Recorder> model{recorder, placed.object, trees.top_levels + 1};
      for_each_candidate(trees.models[placed.mesh], *slabs, limit, visit_triangle, model);
    } else {
      for (std::uint32_t i = 0; i < geometry.meshes[placed.mesh]->triangles.size(); ++i)
        if (visit_triangle(i)) break;
    }
    return ended;
  };
  const auto visit_range = [&](std::uint32_t entry) {
    const NumberRange& range = geometry.numbers[entry];
    switch (range.kind) {
    case NumberRange::Kind::primitive:
      return visit(range.first, geometry.primitives[range.index]);
    case NumberRange::Kind::instance:
      return visit_instance(range.index);
    }
    return false;
  };
  for_each_candidate(trees.top, world, limit, visit_range, recorder);
}

}  // namespace ps
