#pragma once
#include "gui/input/actions.h"
#include "gui/panels/lesson/lesson_panel.h"

namespace ps::gui {

/// The keys that move through lessons.
void add_lesson_actions(Actions& actions, Session& session, LessonShelf& shelf);

}  // namespace ps::gui
