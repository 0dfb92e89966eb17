#pragma once
#include "record/events.h"
#include "scene/scene.h"

namespace ps::gui {

/// All that is known about an event as a table: names to the left, numbers right-aligned in columns, vectors over
/// three of them. Full precision on hover. With `before`, the event as it was when it was pinned, what it had then
/// is above what changed.
void event_numbers(const Event& event, const Scene& scene, const Event* before = nullptr);

}  // namespace ps::gui
