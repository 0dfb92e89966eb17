#pragma once
#include <imgui.h>

#include <string>
#include <vector>

#include "engine/lesson_length.h"
#include "gui/panels/lesson/lesson_panel.h"

namespace ps::gui {

/// A lesson as lists show it.
struct ListedLesson {
  std::string name, title, source;
  std::string part;  ///< of the course
  LessonLength length;
  std::string fault;  ///< why it cannot be read; its title is its name then
};

/// All lessons in their order; read once.
const std::vector<ListedLesson>& listed_lessons();

/// The tick of a lesson that was read to its end, at the left end of its row.
void draw_tick(ImVec2 row, float height);

/// The list of lessons, each with its steps and minutes, and a tick if it was read to the end. A click begins one.
void lesson_list(Session& session, const ReadLessons& read);

}  // namespace ps::gui
