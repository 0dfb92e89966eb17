#pragma once
#include "inspect/events.h"
#include "scene/scene.h"

namespace ps::gui {

/// All that is known about an event as a table: names to the left, numbers right-aligned in columns, vectors over
/// three of them. Full precision on hover.
void event_numbers(const Event& event, const Scene& scene);

}  // namespace ps::gui
