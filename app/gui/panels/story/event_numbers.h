#pragma once
#include <optional>
#include <string>

#include "record/events.h"
#include "scene/scene.h"

namespace ps::gui {

/// A number of an event: its field, and its place in a vector (-1: the field is one number).
struct ClickedNumber {
  std::string key;
  int component = -1;
};

/// All that is known about an event as a table: names to the left, numbers right-aligned in columns, vectors over
/// three of them. Full precision on hover. With `before`, the event as it was when it was pinned, what it had then
/// is above what changed. Answers the number that was clicked; `name` goes
/// before their names.
std::optional<ClickedNumber> event_numbers(const std::string& name, const Event& event, const Scene& scene,
                                           const Event* before = nullptr);

}  // namespace ps::gui
