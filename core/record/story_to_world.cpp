#include "record/story_to_world.h"

namespace ps {
namespace {

/// Events that hold neither points nor lengths go to the last overload.
class ToWorld {
 public:
  explicit ToWorld(const WorkingSpace& space) : space_(space) {}

  void operator()(RayEvent& ray) const {
    point(ray.origin);
    vector(ray.direction);
  }
  void operator()(NodeEvent& node) const {
    if (node.object >= 0) return;  // a box in its model
    point(node.low);
    point(node.high);
    length(node.radius);
  }
  void operator()(SphereTestEvent& test) const { test.discriminant /= space_.scale * space_.scale; }
  void operator()(HitEvent& hit) const { point(hit.point); }
  void operator()(LightEvent& light) const { vector(light.to_light); }
  void operator()(VertexLightEvent& light) const { point(light.position); }
  void operator()(FragmentEvent& fragment) const {
    for (double& depth : fragment.corner_depth) length(depth);
    length(fragment.z);
    fragment.inverse_z *= space_.scale;
  }
  void operator()(ShadowMapEvent& map) const {
    length(map.depth);
    length(map.bias);
    for (ShadowTap& tap : map.taps) length(tap.stored);
  }
  void operator()(StencilEvent& stencil) const {
    length(stencil.surface_z);
    for (VolumeCrossing& crossing : stencil.crossings) {
      length(crossing.z);
      point(crossing.edge_from);
      point(crossing.edge_to);
    }
  }
  void operator()(EnvironmentEvent& environment) const {
    point(environment.centre);
    vector(environment.direction);
  }
  template <class Other>
  void operator()(Other&) const {}

 private:
  void point(Vec3d& p) const { p = space_.to_world(p); }
  void vector(Vec3d& v) const { v /= space_.scale; }
  void length(double& value) const { value /= space_.scale; }

  const WorkingSpace& space_;
};

}  // namespace

void story_to_world(const WorkingSpace& space, std::vector<Event>& events) {
  if (space.is_world()) return;
  const ToWorld to_world(space);
  for (Event& event : events) std::visit(to_world, event.data);
}

}  // namespace ps
