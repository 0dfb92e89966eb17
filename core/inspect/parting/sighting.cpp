#include "inspect/parting/sighting.h"

#include "render/story/story_tree.h"

namespace ps {
namespace {

std::vector<int> rays_of_kind(const PixelStory& story, int parent_ray, RayKind kind) {
  std::vector<int> found;
  for (const int index : events_of_ray<RayEvent>(story.events, parent_ray))
    if (event_as<RayEvent>(story.events, index).kind == kind) found.push_back(index);
  return found;
}

/// The event of type T right below `parent`, -1 if there is none.
template <class T>
int child_of(const std::vector<Event>& events, int parent) {
  for (int i = parent + 1; i < static_cast<int>(events.size()); ++i)
    if (events[static_cast<std::size_t>(i)].parent == parent &&
        std::holds_alternative<T>(events[static_cast<std::size_t>(i)].data))
      return i;
  return -1;
}

/// The fragments that shade the same surface light by light, each in a pass of its own.
std::vector<int> passes_of(const PixelStory& story, const PixelId& id) {
  std::vector<int> passes;
  for (int i = 0; i < static_cast<int>(story.events.size()); ++i) {
    const auto* fragment = std::get_if<FragmentEvent>(&story.events[static_cast<std::size_t>(i)].data);
    if (fragment && fragment->pass == FragmentEvent::Pass::shading && fragment->id == id) passes.push_back(i);
  }
  return passes;
}

}  // namespace

Sighting sight_of_ray(const PixelStory& story, int ray) {
  Sighting sighting;
  sighting.ray = ray;
  const auto hits = events_of_ray<HitEvent>(story.events, ray);
  if (hits.empty()) {
    sighting.seen = child_of<MissEvent>(story.events, ray);
    return sighting;
  }
  sighting.seen = hits.back();
  sighting.id = event_as<HitEvent>(story.events, hits.back()).id;
  sighting.lights = events_of_ray<LightEvent>(story.events, ray);
  sighting.textures = events_of_ray<TextureEvent>(story.events, ray);
  const auto shades = events_of_ray<ShadeEvent>(story.events, ray);
  if (!shades.empty()) sighting.shade = shades.back();
  sighting.mirrored_ray = rays_of_kind(story, ray, RayKind::reflection);
  sighting.refracted_ray = rays_of_kind(story, ray, RayKind::refraction);
  return sighting;
}

Sighting sight_of_fragments(const PixelStory& story) {
  Sighting sighting;
  for (int i = 0; i < static_cast<int>(story.events.size()); ++i) {
    const Event& event = story.events[static_cast<std::size_t>(i)];
    if (std::holds_alternative<WriteEvent>(event.data)) sighting.seen = event.parent;
  }
  if (sighting.seen < 0) return sighting;
  const auto* fragment = std::get_if<FragmentEvent>(&story.events[static_cast<std::size_t>(sighting.seen)].data);
  if (!fragment) return Sighting{};
  sighting.id = fragment->id;
  sighting.textures = events_below<TextureEvent>(story.events, sighting.seen);
  const std::vector<int> passes = passes_of(story, sighting.id);
  if (passes.size() < 2) {
    sighting.lights = events_below<LightEvent>(story.events, sighting.seen);
    sighting.shade = child_of<ShadeEvent>(story.events, sighting.seen);
    return sighting;
  }
  for (const int pass : passes)
    for (const int light : events_below<LightEvent>(story.events, pass)) sighting.lights.push_back(light);
  return sighting;
}

std::vector<int> shadow_rays_of(const PixelStory& story, int ray) { return rays_of_kind(story, ray, RayKind::shadow); }

std::optional<double> seen_depth(const PixelStory& story, const Sighting& sighting) {
  if (sighting.seen < 0) return std::nullopt;
  const EventData& data = story.events[static_cast<std::size_t>(sighting.seen)].data;
  if (const auto* hit = std::get_if<HitEvent>(&data)) return hit->t;
  if (const auto* fragment = std::get_if<FragmentEvent>(&data)) return fragment->z;
  return std::nullopt;
}

}  // namespace ps
