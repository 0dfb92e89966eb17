#pragma once
#include <imgui.h>

#include "record/events.h"

namespace ps::gui {

/// An icon whose shape is the kind of an event and whose colour is its outcome: a right-hand arrow for a
/// ray, hollow shapes for tests that failed, filled ones for what counted. Drawn around `middle`, `size` pixels large.
void draw_event_icon(ImDrawList& list, const Event& event, ImVec2 middle, float size);

}  // namespace ps::gui
