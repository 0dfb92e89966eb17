#pragma once
#include "gui/panels/lesson/lesson_shelf.h"
#include "gui/panels/sheet.h"

namespace ps::gui {

/// What a lesson has for the teacher alone, over the window.
class NotesSheet final : public Sheet {
 public:
  NotesSheet(const PanelHost& host, LessonShelf& shelf) : Sheet(host, "notes"), shelf_(shelf) {}
  /// The notes of the open step; with the first step those of the whole lesson. It closes where no lesson is open, and
  /// with a link that is followed.
  bool draw(const Context& context) override;
  void add_actions(Actions& actions) override;
  void offer(Values& out) override;

 private:
  LessonShelf& shelf_;
};

}  // namespace ps::gui
