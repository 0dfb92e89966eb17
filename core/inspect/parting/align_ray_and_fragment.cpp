#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "inspect/describe.h"
#include "inspect/parting/align_parts.h"
#include "inspect/parting/fragment_fate.h"
#include "inspect/parting/sighting.h"
#include "record/event_fields.h"
#include "render/story/story_tree.h"

namespace ps::parting {
namespace {

/// For events that have no counterpart in the other way of making pictures; no two of them are equal.
std::string alone(std::string_view side, int event) { return fmt::format("{} {}", side, event); }

std::string test_key(const PixelId& id, bool whole_object) {
  return whole_object ? fmt::format("test {}", id.object) : fmt::format("test {}/{}", id.object, id.triangle);
}

/// What light and textures are about, which both ways of making pictures have.
std::optional<std::string> surface_key(const EventData& data) {
  if (std::holds_alternative<LightEvent>(data) || std::holds_alternative<TextureEvent>(data) ||
      std::holds_alternative<ShadeEvent>(data))
    return event_subject(data);
  return std::nullopt;
}

std::string key_of_ray_event(const EventTree& tree, int index) {
  const EventData& data = tree.event(index).data;
  if (std::holds_alternative<HitEvent>(data)) return "seen";
  if (const auto* test = std::get_if<SphereTestEvent>(&data)) return test_key(test->id, true);
  if (const auto* test = std::get_if<TriangleTestEvent>(&data)) return test_key(test->id, false);
  return surface_key(data).value_or(alone("ray", index));
}

std::string key_of_fragment_event(const EventTree& tree, int index, int seen, const Scene& scene) {
  const EventData& data = tree.event(index).data;
  if (index == seen) return "seen";
  if (const auto* fragment = std::get_if<FragmentEvent>(&data))
    return test_key(fragment->id, fragment->sphere_triangle >= 0);
  if (const auto* reject = std::get_if<RejectEvent>(&data); reject && !is_tessellated(scene, reject->id))
    return test_key(reject->id, false);
  return surface_key(data).value_or(alone("fragment", index));
}

/// A ray and a fragment see a point through other roundings.
constexpr double rounding = 2e-3;

bool close(double a, double b) { return std::abs(a - b) <= rounding * std::max({1.0, std::abs(a), std::abs(b)}); }
bool close(const Vec3d& a, const Vec3d& b) { return close(a.x, b.x) && close(a.y, b.y) && close(a.z, b.z); }

/// Light and colour come to the same but for that.
bool same_light(const EventData& ray, const EventData& fragment) {
  const auto *light_a = std::get_if<LightEvent>(&ray), *light_b = std::get_if<LightEvent>(&fragment);
  if (light_a && light_b)
    return close(light_a->diffuse, light_b->diffuse) && close(light_a->specular, light_b->specular);
  const auto *shade_a = std::get_if<ShadeEvent>(&ray), *shade_b = std::get_if<ShadeEvent>(&fragment);
  return shade_a && shade_b && close(shade_a->light, shade_b->light) && close(shade_a->extra, shade_b->extra);
}

/// A hit and a fragment, or a test and a triangle's fate, are equal if their outcomes are equal.
bool agree(const EventData& ray, const EventData& fragment) {
  if (same_light(ray, fragment)) return true;
  const auto* covers = std::get_if<FragmentEvent>(&fragment);
  if (!covers) return false;
  if (const auto* hit = std::get_if<HitEvent>(&ray)) return hit->id.object == covers->id.object;
  const auto behind = [&](const auto* test) {
    return test && test->outcome == TestOutcome::farther && covers->depth == FragmentEvent::Depth::failed;
  };
  return behind(std::get_if<SphereTestEvent>(&ray)) || behind(std::get_if<TriangleTestEvent>(&ray));
}

class MixedAligner {
 public:
  MixedAligner(const EventTree& ray, const EventTree& fragment, const Scene& scene)
      : ray_(ray), fragment_(fragment), scene_(scene), seen_(sight_of_fragments(fragment.story()).seen) {}

  std::vector<AlignedRow> rows() {
    const int eye = eye_ray(ray_.story().events);
    if (eye < 0 || seen_ < 0 || ray_.below(eye).empty()) return {};
    std::vector<int> of_fragments, endings;
    for (const int root : fragment_.below(-1)) {
      if (root == seen_) continue;
      const bool ending = std::holds_alternative<PixelEvent>(fragment_.event(root).data);
      (ending ? endings : of_fragments).push_back(root);
    }
    of_fragments.push_back(seen_);
    for (const int child : fragment_.below(seen_)) of_fragments.push_back(child);
    rows_.push_back({eye, -1, 0, false});
    pair_up(ray_.below(eye), of_fragments, 1);
    std::vector<int> rest;
    for (const int root : ray_.below(-1))
      if (root != eye) rest.push_back(root);
    pair_up(rest, endings, 0);
    return std::move(rows_);
  }

 private:
  void pair_up(const std::vector<int>& of_ray, const std::vector<int>& of_fragments, int depth) {
    std::vector<std::string> keys_ray, keys_fragment;
    const auto ending = [](const EventTree& tree, int index) {
      return std::holds_alternative<PixelEvent>(tree.event(index).data);
    };
    for (const int index : of_ray) keys_ray.push_back(ending(ray_, index) ? "pixel" : key_of_ray_event(ray_, index));
    for (const int index : of_fragments)
      keys_fragment.push_back(ending(fragment_, index) ? "pixel"
                                                       : key_of_fragment_event(fragment_, index, seen_, scene_));
    std::size_t i = 0, j = 0;
    for (const auto& [partner_ray, partner_fragment] : common_sequence(keys_ray, keys_fragment)) {
      while (i < partner_ray) only_ray(of_ray[i++], depth);
      while (j < partner_fragment) only_fragment(of_fragments[j++], depth);
      both(of_ray[i++], of_fragments[j++], depth);
    }
    while (i < of_ray.size()) only_ray(of_ray[i++], depth);
    while (j < of_fragments.size()) only_fragment(of_fragments[j++], depth);
  }

  void both(int ray, int fragment, int depth) {
    const Event &a = ray_.event(ray), &b = fragment_.event(fragment);
    rows_.push_back({ray, fragment, depth, agree(a.data, b.data) || describe(a, scene_) == describe(b, scene_)});
    for (const int child : ray_.below(ray)) only_ray(child, depth + 1);
    if (fragment != seen_)
      for (const int child : fragment_.below(fragment)) only_fragment(child, depth + 1);
  }
  void only_ray(int event, int depth) {
    rows_.push_back({event, -1, depth, false});
    for (const int child : ray_.below(event)) only_ray(child, depth + 1);
  }
  void only_fragment(int event, int depth) {
    rows_.push_back({-1, event, depth, false});
    if (event == seen_) return;  // what is below it has rows of its own
    for (const int child : fragment_.below(event)) only_fragment(child, depth + 1);
  }

  const EventTree& ray_;
  const EventTree& fragment_;
  const Scene& scene_;
  const int seen_;
  std::vector<AlignedRow> rows_;
};

}  // namespace

std::vector<AlignedRow> align_ray_and_fragment(const EventTree& ray, const EventTree& fragment, const Scene& scene) {
  return MixedAligner(ray, fragment, scene).rows();
}

}  // namespace ps::parting
