#pragma once
#include "gui/panels/lesson/lesson_panel.h"

namespace ps::gui {

/// Height of the strip with its margins, window pixels.
float caption_height();
/// The step's text, a few lines at a time, in letters that are read from the last row. Draws nothing without a lesson.
void caption_strip(Session& session, LessonReading& state);

}  // namespace ps::gui
