// The events of a ray tracer's story in space.
#include <fmt/format.h>

#include <cmath>
#include <map>
#include <numbers>

#include "inspect/space_parts.h"
#include "math/portable.h"
#include "record/value_text.h"
#include "render/story/names.h"
#include "render/story/story_tree.h"
#include "scene/world.h"

namespace ps {
namespace {

constexpr double endless_share = 0.8;  // how long a ray that meets nothing is drawn, of the bounds' radius

class RayParts {
 public:
  RayParts(const SpaceInputs& inputs, SpaceModel& model)
      : inputs_(inputs), events_(inputs.story->events), model_(model) {}

  void add() {
    for (int i = 0; i < static_cast<int>(events_.size()); ++i) {
      const EventData& data = events_[static_cast<std::size_t>(i)].data;
      if (const auto* ray = std::get_if<RayEvent>(&data)) {
        if (ray->kind == RayKind::shadow)
          add_shadow_ray(i, *ray);
        else
          add_ray(i, *ray);
      } else if (const auto* hit = std::get_if<HitEvent>(&data)) {
        add_hit(i, *hit);
      } else if (const auto* light = std::get_if<LightEvent>(&data)) {
        add_light(i, *light);
      } else if (const auto* node = std::get_if<NodeEvent>(&data)) {
        add_node(i, *node);
      }
    }
  }

 private:
  const Event& event(int i) const { return events_[static_cast<std::size_t>(i)]; }

  /// An item that belongs to an event, with the share and the bounces of the ray that it is part of.
  SpaceItem part_of(int index) const {
    SpaceItem item;
    item.event = index;
    for (int i = index; i >= 0; i = event(i).parent)
      if (const auto* ray = std::get_if<RayEvent>(&event(i).data); ray && ray->kind != RayKind::shadow) {
        item.contribution = ray->share;
        item.level = ray->depth;
        break;
      }
    return item;
  }

  Vec3d along(const RayEvent& ray, double share_of_radius) const {
    const double length = std::sqrt(dot(ray.direction, ray.direction));
    return ray.origin + ray.direction * (share_of_radius * inputs_.bounds.radius / (length > 0 ? length : 1));
  }

  void add_ray(int index, const RayEvent& ray) {
    SpaceItem item = part_of(index);
    item.kind = ray.kind == RayKind::eye ? SpaceKind::eye_ray : SpaceKind::reflection_ray;
    item.shape = SpaceShape::arrow;
    // One that leaves the scene may have to cross all of it first.
    item.points = {ray.origin, along(ray, ray.kind == RayKind::eye ? 3 * endless_share : endless_share)};
    for (const int hit : events_of_ray<HitEvent>(events_, index))
      item.points[1] = event_as<HitEvent>(events_, hit).point;
    if (ray.kind == RayKind::reflection) item.label = number_text(ray.share) + " of the colour";
    model_.items.push_back(std::move(item));
  }

  /// The light that a shadow ray asked about is reported right after it, under the same ray.
  const LightEvent* light_after(int index) const {
    for (int i = index + 1; i < static_cast<int>(events_.size()); ++i) {
      if (event(i).parent != event(index).parent) continue;
      return std::get_if<LightEvent>(&event(i).data);
    }
    return nullptr;
  }

  /// Where the blocker was met: the accepted test with the smallest t. `any hit` ends at the first one.
  std::optional<double> blocked_at(int index) const {
    std::optional<double> nearest;
    const auto take = [&](std::optional<double> t) {
      if (t && (!nearest || *t < *nearest)) nearest = t;
    };
    const RayEvent& ray = event_as<RayEvent>(events_, index);
    for (const int i : events_of_ray<SphereTestEvent>(events_, index)) {
      const auto& test = event_as<SphereTestEvent>(events_, i);
      if (test.outcome != TestOutcome::accepted || !test.roots) continue;
      take((*test.roots)[0] > ray.t_min ? (*test.roots)[0] : (*test.roots)[1]);
    }
    for (const int i : events_of_ray<TriangleTestEvent>(events_, index)) {
      const auto& test = event_as<TriangleTestEvent>(events_, i);
      if (test.outcome == TestOutcome::accepted) take(test.t);
    }
    return nearest;
  }

  void add_shadow_ray(int index, const RayEvent& ray) {
    const LightEvent* light = light_after(index);
    SpaceItem item = part_of(index);
    item.shape = SpaceShape::line;
    item.points = {ray.origin,
                   std::isfinite(ray.t_max) ? ray.origin + ray.direction * ray.t_max : along(ray, sunward_share)};
    item.kind = SpaceKind::shadow_ray_lit;
    if (light && light->blocker) {
      item.kind = SpaceKind::shadow_ray_blocked;
      if (const auto t = blocked_at(index)) item.points[1] = ray.origin + ray.direction * *t;
      item.label = fmt::format("blocked by {}", primitive_name(inputs_.scene, *light->blocker));
    }
    model_.items.push_back(std::move(item));
    if (light) asked_[event(index).parent].push_back(light);
  }

  /// Lights that no shadow ray was sent to: shadows are off, or maps give them.
  void add_light(int index, const LightEvent& light) {
    if (light.kind == LightKind::ambient) return;
    for (const LightEvent* asked : asked_[event(index).parent])
      if (asked == &light) return;
    const auto hits = events_of_ray<HitEvent>(events_, event(index).parent);
    if (hits.empty()) return;
    const Vec3d from = event_as<HitEvent>(events_, hits.front()).point;
    SpaceItem item = part_of(index);
    item.kind = SpaceKind::light_direction;
    const RayEvent towards{RayKind::shadow, from, light.to_light, 0, 1, 0, 0, {}};
    item.points = {from, light.kind == LightKind::point ? from + light.to_light : along(towards, sunward_share)};
    model_.items.push_back(std::move(item));
  }

  void add_hit(int index, const HitEvent& hit) {
    SpaceItem item = part_of(index);
    item.kind = SpaceKind::hit_point;
    item.shape = SpaceShape::point;
    item.points = {hit.point};
    item.label = primitive_name(inputs_.scene, hit.id);
    const SpaceItem like = item;
    if (const auto corners = world_triangle(inputs_.scene, hit.id)) add_triangle(*corners, hit.weights, like, model_);
    model_.items.push_back(std::move(item));
    add_normal(SpaceKind::shading_normal, hit.point, hit.shading_normal, like, inputs_, model_);
    const Vec3d apart = hit.shading_normal - hit.geometric_normal;
    if (dot(apart, apart) > 1e-6)
      add_normal(SpaceKind::geometric_normal, hit.point, hit.geometric_normal, like, inputs_, model_);
  }

  const Instance* instance_of(int object) const {
    const auto& objects = inputs_.scene.geometry->objects;
    if (object < 0 || static_cast<std::size_t>(object) >= objects.size()) return nullptr;
    return std::get_if<Instance>(&objects[static_cast<std::size_t>(object)].shape);
  }

  /// A way along all edges of a box in a model, some of them twice, in the world.
  static std::vector<Vec3d> placed_box(const NodeEvent& node, const Transform& transform) {
    std::vector<Vec3d> points;
    for (const unsigned corner : {0u, 1u, 3u, 2u, 0u, 4u, 5u, 1u, 5u, 7u, 3u, 7u, 6u, 2u, 6u, 4u}) {
      Vec3d point = node.low;
      for (int axis = 0; axis < 3; ++axis)
        if ((corner >> axis & 1u) != 0) point[axis] = node.high[axis];
      points.push_back(to_world(transform, point));
    }
    return points;
  }

  /// A box is drawn once, however many rays come to it; entered if any ray did.
  void add_node(int index, const NodeEvent& node) {
    const auto [place, first] = nodes_.try_emplace({node.object, node.node}, model_.items.size());
    if (!first) {
      if (node.entered) model_.items[place->second].emphasised = true;
      return;
    }
    SpaceItem item = part_of(index);
    item.kind = SpaceKind::node;
    if (node.radius > 0) {
      item.shape = SpaceShape::line;
      item.points = sphere_outline((node.low + node.high) * 0.5, node.radius);
    } else if (const Instance* instance = instance_of(node.object)) {
      item.shape = SpaceShape::line;
      item.points = placed_box(node, instance->transform);
    } else {
      item.shape = SpaceShape::box;
      item.points = {node.low, node.high};
    }
    item.level = node.level;
    item.emphasised = node.entered;
    model_.items.push_back(std::move(item));
  }

  const SpaceInputs& inputs_;
  const std::vector<Event>& events_;
  SpaceModel& model_;
  std::map<int, std::vector<const LightEvent*>> asked_;  // by the event that they belong to
  std::map<std::pair<int, int>, std::size_t> nodes_;     // item of each node, by its object and number
};

}  // namespace

std::vector<Vec3d> sphere_outline(const Vec3d& centre, double radius) {
  constexpr int steps = 32;
  std::vector<Vec3d> points;
  const auto arc = [&](int first, int second, int to) {
    for (int i = 0; i <= to; ++i) {
      const double turn = 2 * std::numbers::pi * i / steps;
      Vec3d away(0);
      away[first] = portable::cos(turn) * radius;
      away[second] = portable::sin(turn) * radius;
      points.push_back(centre + away);
    }
  };
  arc(0, 2, steps);              // from x through z, and back to x
  arc(0, 1, steps + steps / 4);  // from x through y, and on to y
  arc(1, 2, steps);
  return points;
}

void add_rays(const SpaceInputs& inputs, SpaceModel& model) { RayParts(inputs, model).add(); }

}  // namespace ps
