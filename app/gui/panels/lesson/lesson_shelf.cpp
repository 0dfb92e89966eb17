#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <sstream>

#include "base/resources.h"
#include "engine/lesson_place.h"
#include "gui/panels/lesson/lesson_panel.h"

namespace ps::gui {

const Lesson* LessonShelf::open(Session& session) {
  const std::string& wanted = session.document().lesson;
  if (wanted.empty()) return nullptr;
  if (wanted != name_) {
    name_ = wanted;
    lesson_.reset();
    load(session);
    if (!watch_) watch_ = std::make_unique<FileWatch>(wake_);
    watch_->watch({lesson_file(name_)});
  }
  return lesson_ ? &*lesson_ : nullptr;
}

void LessonShelf::load(Session& session) {
  ++version_;
  try {
    lesson_ = load_lesson(name_);
  } catch (const InputError& error) {
    session.messages().say({Message::Kind::error, error.what(), Message::About::lesson, name_});
  }
}

void LessonShelf::update(Session& session) {
  // A change while no lesson is open is taken when this one is open again.
  if (!watch_ || session.document().lesson != name_ || !watch_->take_changed()) return;
  session.messages().remove([&](const Message& message) {  // it may have been mended
    return message.about == Message::About::lesson && message.file == name_;
  });
  try {
    lesson_ = load_lesson(name_);
  } catch (const InputError& error) {
    return session.messages().say({Message::Kind::error, error.what(), Message::About::lesson, name_});
  }
  ++version_;
  go_to_step(session, name_, session.document().step);
}

void go_to_step(Session& session, const std::string& name, int step) {
  try {
    const Lesson lesson = load_lesson(name);
    if (lesson.steps.empty()) return;
    const int last = static_cast<int>(lesson.steps.size()) - 1;
    const int target = std::clamp(step, 0, last);
    if (is_own_lesson(lesson.name) && session.document().lesson != lesson.name)
      session.loader().note_recent(lesson.name);
    session.edit(fmt::format("{}, step {}", lesson.title, target + 1),
                 [&](Document& document) { document = lesson_document(lesson, target, document); });
  } catch (const InputError& error) {
    session.say(Message::Kind::error, error.what());
  }
}

void move_step(Session& session, LessonShelf& shelf, int by) {
  const Lesson* lesson = shelf.open(session);
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

void follow_column(const Session& session, LessonShelf& shelf) {
  const Document& document = session.document();
  LessonColumn& column = shelf.column;
  const bool same_step = column.lesson == document.lesson && column.step == document.step;
  // Undo, and a step that is put back, have a stage too, but it was not chosen.
  const bool chosen = column.stage != document.layout.stage && column.change == session.change();
  if (!same_step || shelf.turn_to_verdict || !shelf.shown_option.empty())
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

void read_lesson(Session& session, LessonShelf& shelf, int by) {
  ReadPage& read = session.document().mode == ScreenMode::presenter ? shelf.caption : shelf.text;
  const bool tool = shelf.column.shared && shelf.column.shows == ColumnShows::tool;
  const bool last = read.page + 1 >= read.pages;
  if (shelf.column.shared && (by < 0 ? tool : !tool && last)) {
    turn_column(shelf.column);
    return;
  }
  const int page = read.page + by;
  if (read.seen.lately() && page >= 0 && page < read.pages) {
    read.page = page;
    return;
  }
  read.turned_back = by < 0;
  move_step(session, shelf, by);
}

void move_lesson(Session& session, int by) {
  const auto& names = lesson_names();
  if (names.empty()) return;
  const auto here = std::find(names.begin(), names.end(), session.document().lesson);
  if (here == names.end()) {
    go_to_step(session, names.front(), 0);
    return;
  }
  const auto place = std::distance(names.begin(), here) + by;
  if (place >= 0 && place < std::ssize(names)) go_to_step(session, names[static_cast<std::size_t>(place)], 0);
}

std::set<std::string> parse_read_lessons(const std::string& lines) {
  std::set<std::string> names;
  std::istringstream text(lines);
  for (std::string line; std::getline(text, line);)
    if (!line.empty()) names.insert(line);
  return names;
}

void note_read(LessonShelf& shelf, const Lesson& lesson, int step, const ReadPage& page) {
  if (step + 1 != static_cast<int>(lesson.steps.size()) || page.page + 1 != page.pages) return;
  if (!shelf.read.names.insert(lesson.name).second || !shelf.read.remember) return;
  std::string lines;
  for (const std::string& name : shelf.read.names) lines += name + '\n';
  shelf.read.remember(lines);
}

void close_lesson(Session& session) {
  session.navigate([](Document& document) { document.mode = ScreenMode::explore; });
  session.edit("close the lesson", [](Document& document) {
    document.lesson.clear();
    document.step = 0;
  });
}

}  // namespace ps::gui
