#pragma once
#include <functional>
#include <string>

#include "engine/lesson_search.h"
#include "gui/panels/lesson/lesson_list.h"
#include "gui/platform/texture.h"

namespace ps::gui {

/// A lesson or a step of one that a search has found.
struct HitRow {
  const LessonHit& hit;
  const ListedLesson& lesson;
  std::string name;  ///< of the control
  bool ticked = false;
  bool selected = false;
  bool reveal = false;  ///< scrolls to it if it is selected
};

/// The lesson's small picture and title, and below it the step that was found with the text around the words. Answers
/// whether it was clicked. `picture` is asked for while the row is in sight.
bool hit_row(const HitRow& row, const std::function<const Texture*()>& picture);

}  // namespace ps::gui
