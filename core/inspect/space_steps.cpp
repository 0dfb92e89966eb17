#include <algorithm>

#include "inspect/space_model.h"
#include "options/renderer_kind.h"
#include "render/story/story_tree.h"

namespace ps {
namespace {

/// The shadow ray that was sent for a light: reported right before it, under the same event.
int shadow_ray_before(const std::vector<Event>& events, int light) {
  const int parent = events[static_cast<std::size_t>(light)].parent;
  for (int i = light - 1; i > parent; --i) {
    const Event& event = events[static_cast<std::size_t>(i)];
    if (event.parent != parent) continue;
    const auto* ray = std::get_if<RayEvent>(&event.data);
    return ray && ray->kind == RayKind::shadow ? i : -1;
  }
  return -1;
}

int fragment_before(const std::vector<Event>& events, int index) {
  for (int i = index; i >= 0; --i)
    if (std::holds_alternative<FragmentEvent>(events[static_cast<std::size_t>(i)].data)) return i;
  return -1;
}

}  // namespace

int shown_event(const SpaceModel& model, const PixelStory& story, int selected) {
  const std::vector<Event>& events = story.events;
  if (selected < 0 || static_cast<std::size_t>(selected) >= events.size()) return -1;
  const auto has_items = [&](int index) {
    return index >= 0 && std::binary_search(model.steps.begin(), model.steps.end(), index);
  };
  if (has_items(selected)) return selected;
  const EventData& data = events[static_cast<std::size_t>(selected)].data;
  if (std::holds_alternative<NodeEvent>(data)) return selected;  // shown, though not played
  if (std::holds_alternative<LightEvent>(data))
    if (const int ray = shadow_ray_before(events, selected); has_items(ray)) return ray;
  if (std::holds_alternative<ShadeEvent>(data) || std::holds_alternative<ReflectionEvent>(data) ||
      std::holds_alternative<TextureEvent>(data) || std::holds_alternative<LightEvent>(data)) {
    const auto hits = events_of_ray<HitEvent>(events, ray_of(events, selected));
    if (!hits.empty() && has_items(hits.front())) return hits.front();
  }
  if (draws_fragments(story.renderer))
    if (const int fragment = fragment_before(events, selected); has_items(fragment)) return fragment;
  for (int above = events[static_cast<std::size_t>(selected)].parent; above >= 0;
       above = events[static_cast<std::size_t>(above)].parent)
    if (has_items(above)) return above;
  return -1;
}

}  // namespace ps
