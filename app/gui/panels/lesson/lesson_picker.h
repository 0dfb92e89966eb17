#pragma once
#include <functional>
#include <string>
#include <utility>

#include "engine/lesson_search.h"
#include "gui/panels/lesson/lesson_panel.h"
#include "gui/work/thumbnails.h"

namespace ps::gui {

/// All lessons over the whole window, as pictures, and a search in their texts.
struct LessonPicker {
  /// `wake` may be called from any thread.
  explicit LessonPicker(std::function<void()> wake) : thumbnails(std::move(wake)) {}

  bool open = false;
  bool just_opened = false;
  std::string search, searched;  ///< as it is typed, and what `found` was found for
  LessonHits found;
  int selected = 0;  ///< of the pictures, or of what is found
  Thumbnails thumbnails;
};

/// The open lesson is the selected one.
void open_lesson_picker(LessonPicker& picker, const Session& session);

/// Draws it while it is open. A click, or Enter for the selected one, opens a lesson or the step that was found; Esc or
/// a click outside closes it.
void lesson_picker(Session& session, LessonPicker& picker, const ReadLessons& read);

}  // namespace ps::gui
