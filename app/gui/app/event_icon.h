#pragma once
#include <imgui.h>

#include "record/events.h"

namespace ps::gui {

/// A small picture that tells the kind of an event by its shape and how it went by its colour: a right-hand arrow for a
/// ray, hollow shapes for tests that failed, filled ones for what counted. Drawn around `middle`, `size` pixels large.
void draw_event_icon(ImDrawList& list, const Event& event, ImVec2 middle, float size);

}  // namespace ps::gui
