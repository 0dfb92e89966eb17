#pragma once
#include "gui/panels/lesson/lesson_shelf.h"
#include "gui/panels/sheet.h"

namespace ps::gui {

/// What a lesson has for the teacher alone, over the window.
class NotesSheet final : public Sheet {
 public:
  NotesSheet(const PanelHost& host, LessonShelf& shelf)
      : Sheet(host, "notes", {"For the teacher", {640, 420}}), shelf_(shelf) {}
  void add_actions(Actions& actions) override;

 protected:
  bool has_subject() override { return shelf_.open() && !shelf_.open()->steps.empty(); }
  /// The notes of the open step; with the first step those of the whole lesson. A link that is followed closes it.
  void draw_sheet() override;

 private:
  LessonShelf& shelf_;
};

}  // namespace ps::gui
