#pragma once
#include <vector>

#include "record/events.h"

namespace ps {

/// Reading aids for the flat list of events in a story.

/// The ray that event `index` belongs to: its nearest ancestor that is a RayEvent, or -1.
int ray_of(const std::vector<Event>& events, int index);

/// All events of type T, in order. They lie in the list, which must not be a temporary one.
template <class T>
std::vector<const T*> events_of(const std::vector<Event>& events) {
  std::vector<const T*> found;
  for (const Event& event : events)
    if (const auto* one = std::get_if<T>(&event.data)) found.push_back(one);
  return found;
}
template <class T>
std::vector<const T*> events_of(std::vector<Event>&& events) = delete;

/// Events of type T that belong directly to ray `ray` (-1: to no ray), in order, as indices.
template <class T>
std::vector<int> events_of_ray(const std::vector<Event>& events, int ray) {
  std::vector<int> found;
  for (int i = 0; i < static_cast<int>(events.size()); ++i)
    if (std::holds_alternative<T>(events[static_cast<std::size_t>(i)].data) && ray_of(events, i) == ray)
      found.push_back(i);
  return found;
}

/// Events of type T with event `ancestor` somewhere above them, in order, as indices.
template <class T>
std::vector<int> events_below(const std::vector<Event>& events, int ancestor) {
  std::vector<int> found;
  for (int i = ancestor + 1; i < static_cast<int>(events.size()); ++i) {
    if (!std::holds_alternative<T>(events[static_cast<std::size_t>(i)].data)) continue;
    for (int above = events[static_cast<std::size_t>(i)].parent; above >= ancestor && above >= 0;
         above = events[static_cast<std::size_t>(above)].parent)
      if (above == ancestor) {
        found.push_back(i);
        break;
      }
  }
  return found;
}

/// The event at `index`, which must hold a T.
template <class T>
const T& event_as(const std::vector<Event>& events, int index) {
  return std::get<T>(events.at(static_cast<std::size_t>(index)).data);
}

/// The eye ray, or -1 in a story without rays.
int eye_ray(const std::vector<Event>& events);

}  // namespace ps
