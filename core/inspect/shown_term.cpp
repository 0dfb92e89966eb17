#include "inspect/shown_term.h"

#include <algorithm>

#include "render/story/story_tree.h"

namespace ps {
namespace {

class Terms {
 public:
  explicit Terms(const PixelStory& story) : story_(story), events_(story.events) {}

  bool has(int event) const {
    return event >= 0 && std::any_of(story_.ledger.begin(), story_.ledger.end(),
                                     [&](const LedgerLine& line) { return line.event == event; });
  }
  int of(int selected) const {
    if (has(selected)) return selected;
    const Event& event = events_[static_cast<std::size_t>(selected)];
    if (const auto* ray = std::get_if<RayEvent>(&event.data)) {
      if (ray->kind == RayKind::shadow) return of_shadow_ray(selected);
      if (ray->kind != RayKind::eye) return of_share(ray_of(events_, selected));
    }
    if (const int written = of_fragment(selected); written >= 0) return written;
    const int ray = std::holds_alternative<RayEvent>(event.data) ? selected : ray_of(events_, selected);
    if (ray < 0) return -1;
    if (event_as<RayEvent>(events_, ray).kind == RayKind::shadow) return of_shadow_ray(ray);
    return last_with_term<ShadeEvent>(ray);
  }

 private:
  template <class T>
  int last_with_term(int ray) const {
    const auto found = events_of_ray<T>(events_, ray);
    return !found.empty() && has(found.back()) ? found.back() : -1;
  }
  /// The light that a shadow ray asked about is reported right after it, under the same event.
  int of_shadow_ray(int ray) const {
    const int parent = events_[static_cast<std::size_t>(ray)].parent;
    for (int i = ray + 1; i < static_cast<int>(events_.size()); ++i) {
      const Event& event = events_[static_cast<std::size_t>(i)];
      if (event.parent != parent) continue;
      return std::holds_alternative<LightEvent>(event.data) && has(i) ? i : -1;
    }
    return -1;
  }
  /// What ray `ray` takes from the rays that it sent on.
  int of_share(int ray) const {
    const int mirrored = last_with_term<ReflectionEvent>(ray);
    return mirrored >= 0 ? mirrored : last_with_term<RefractionEvent>(ray);
  }
  /// What a fragment wrote is below it.
  int of_fragment(int event) const {
    for (int above = event; above >= 0; above = events_[static_cast<std::size_t>(above)].parent) {
      if (!std::holds_alternative<FragmentEvent>(events_[static_cast<std::size_t>(above)].data)) continue;
      for (const int write : events_below<WriteEvent>(events_, above))
        if (has(write)) return write;
      // On the canvas the write follows its fragment.
      const auto next = static_cast<std::size_t>(above) + 1;
      const bool writes = next < events_.size() && std::holds_alternative<WriteEvent>(events_[next].data);
      return writes && has(above + 1) ? above + 1 : -1;
    }
    return -1;
  }

  const PixelStory& story_;
  const std::vector<Event>& events_;
};

}  // namespace

int shown_term(const PixelStory& story, int selected) {
  if (selected < 0 || static_cast<std::size_t>(selected) >= story.events.size()) return -1;
  return Terms(story).of(selected);
}

}  // namespace ps
