#include "inspect/microscope/event_of_triangle.h"

#include <optional>

namespace ps {
namespace {

std::optional<PixelId> drawn_or_rejected(const EventData& data) {
  if (const auto* fragment = std::get_if<FragmentEvent>(&data)) return fragment->id;
  if (const auto* reject = std::get_if<RejectEvent>(&data)) return reject->id;
  return std::nullopt;
}

}  // namespace

int event_of_triangle(const PixelStory& story, const MicroTriangle& triangle) {
  int rejected = -1;
  for (std::size_t i = 0; i < story.events.size(); ++i) {
    const EventData& data = story.events[i].data;
    if (drawn_or_rejected(data) != triangle.id) continue;
    if (std::holds_alternative<FragmentEvent>(data)) return static_cast<int>(i);
    rejected = static_cast<int>(i);
  }
  return rejected;
}

int triangle_of_event(const PixelStory& story, const MicroReading& reading, int event) {
  for (int i = event; i >= 0 && static_cast<std::size_t>(i) < story.events.size();
       i = story.events[static_cast<std::size_t>(i)].parent) {
    const auto id = drawn_or_rejected(story.events[static_cast<std::size_t>(i)].data);
    if (!id) continue;
    int found = -1;  // all triangles of a tessellated sphere have its name: best one that covers the point
    for (std::size_t t = 0; t < reading.triangles.size(); ++t)
      if (reading.triangles[t].id == *id && (found < 0 || reading.triangles[t].covered)) found = static_cast<int>(t);
    return found;
  }
  return -1;
}

}  // namespace ps
