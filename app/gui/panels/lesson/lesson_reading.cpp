// Pages, steps, and the place that text and tool share.
#include <limits>

#include "gui/panels/lesson/lesson_panel.h"

namespace ps::gui {

void move_step(Session& session, LessonReading& state, int by) {
  const Lesson* lesson = state.shelf.open();
  if (!lesson) return;
  const int step = session.document().step + by;
  if (step >= 0 && step < static_cast<int>(lesson->steps.size())) go_to_step(session, lesson->name, step);
}

void follow_step(const Session& session, ReadPage& read) {
  const Document& document = session.document();
  if (read.lesson == document.lesson && read.step == document.step) return;
  const bool went_back = read.lesson == document.lesson && document.step == read.step - 1;
  read.page = went_back && read.turned_back ? std::numeric_limits<int>::max() : 0;
  read.turned_back = false;
  read.lesson = document.lesson;
  read.step = document.step;
}

void follow_column(const Session& session, LessonReading& state) {
  const Document& document = session.document();
  LessonColumn& column = state.column;
  const bool same_step = column.lesson == document.lesson && column.step == document.step;
  // Undo, and a step that is put back, have a stage too, but it was not chosen.
  const bool chosen = column.stage != document.layout.stage && column.change == session.change();
  if (!same_step || state.questions.turn_to_verdict || !state.shown_option.empty())
    column.shows = ColumnShows::text;
  else if (chosen)
    column.shows = ColumnShows::tool;
  column.lesson = document.lesson;
  column.step = document.step;
  column.stage = document.layout.stage;
  column.change = session.change();
}

void turn_column(LessonColumn& column) {
  column.shows = column.shows == ColumnShows::text ? ColumnShows::tool : ColumnShows::text;
}

void read_lesson(Session& session, LessonReading& state, int by) {
  const bool presents = session.document().mode == ScreenMode::presenter;
  ReadPage& read = presents ? state.caption : state.text;
  const bool tool = state.column.shared && state.column.shows == ColumnShows::tool;
  const bool last = read.page + 1 >= read.pages;
  if (state.column.shared && (by < 0 ? tool : !tool && last)) {
    turn_column(state.column);
    return;
  }
  const int page = read.page + by;
  if (read.seen.lately() && page >= 0 && page < read.pages) {
    read.page = page;
    return;
  }
  if (presents && by > 0 && read.asks && read.seen.lately()) {
    state.questions.take(session, "", {});
    return;
  }
  read.turned_back = by < 0;
  move_step(session, state, by);
}

void note_read(LessonReading& state, const Lesson& lesson, int step, const ReadPage& page) {
  if (step + 1 != static_cast<int>(lesson.steps.size()) || page.page + 1 != page.pages) return;
  if (!state.read.names.insert(lesson.name).second || !state.read.remember) return;
  std::string lines;
  for (const std::string& name : state.read.names) lines += name + '\n';
  state.read.remember(lines);
}

}  // namespace ps::gui
