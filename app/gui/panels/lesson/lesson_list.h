#pragma once
#include <string>
#include <vector>

#include "engine/lesson_length.h"
#include "engine/lesson_search.h"
#include "gui/panels/lesson/lesson_panel.h"

namespace ps::gui {

/// A lesson as lists show it.
struct ListedLesson {
  std::string name, title, source;
  std::string part;                ///< of the course
  std::vector<std::string> steps;  ///< their headings
  LessonLength length;
  std::string fault;  ///< why it cannot be read; its title is its name then
};

/// All lessons in their order; read once.
const std::vector<ListedLesson>& listed_lessons();

/// For a search in their texts, made when first asked for; lessons have the same numbers there.
const LessonIndex& lesson_index();

/// "7 steps, 12 min"
std::string short_length(const LessonLength& length);

/// Its source, whether it was read to the end, and how its minutes follow.
std::string lesson_tooltip(const ListedLesson& lesson, const ReadLessons& read);

/// The list of lessons, each with its steps and minutes, and a tick if it was read to the end. A click begins one.
/// Answers whether the picker with pictures and a search was asked for.
bool lesson_list(Session& session, const ReadLessons& read);

}  // namespace ps::gui
