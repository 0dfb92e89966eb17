#pragma once
#include "engine/lesson.h"
#include "gui/session/session.h"

namespace ps::gui {

/// The options that a step sets differently in A and B, or else all that it sets, as controls for both: what its text
/// is about can be changed where it is read. Draws nothing for a step that sets none.
void step_controls(Session& session, const LessonStep& step);

}  // namespace ps::gui
