#include "render/story/story_tree.h"

namespace ps {

int ray_of(const std::vector<Event>& events, int index) {
  int above = events.at(static_cast<std::size_t>(index)).parent;
  while (above >= 0 && !std::holds_alternative<RayEvent>(events.at(static_cast<std::size_t>(above)).data))
    above = events[static_cast<std::size_t>(above)].parent;
  return above;
}

int eye_ray(const std::vector<Event>& events) {
  for (std::size_t i = 0; i < events.size(); ++i) {
    const auto* ray = std::get_if<RayEvent>(&events[i].data);
    if (ray && ray->kind == RayKind::eye) return static_cast<int>(i);
  }
  return -1;
}

}  // namespace ps
