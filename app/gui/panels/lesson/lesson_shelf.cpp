#include "gui/panels/lesson/lesson_shelf.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/resources.h"
#include "engine/lesson_place.h"

namespace ps::gui {

const Lesson* LessonShelf::open() {
  const std::string& wanted = session_.document().lesson;
  if (wanted.empty()) return nullptr;
  if (wanted != name_) {
    name_ = wanted;
    lesson_.reset();
    load();
    if (!watch_) watch_ = std::make_unique<FileWatch>(wake_);
    watch_->watch({lesson_file(name_)});
  }
  return lesson_ ? &*lesson_ : nullptr;
}

void LessonShelf::load() {
  ++version_;
  try {
    lesson_ = load_lesson(name_);
  } catch (const InputError& error) {
    session_.messages().say({Message::Kind::error, error.what(), Message::About::lesson, name_});
  }
}

void LessonShelf::update() {
  // A change while no lesson is open is taken when this one is open again.
  if (!watch_ || session_.document().lesson != name_ || watch_->take_changed().empty()) return;
  session_.messages().remove([&](const Message& message) {  // it may have been mended
    return message.about == Message::About::lesson && message.file == name_;
  });
  try {
    lesson_ = load_lesson(name_);
  } catch (const InputError& error) {
    return session_.messages().say({Message::Kind::error, error.what(), Message::About::lesson, name_});
  }
  ++version_;
  go_to_step(session_, name_, session_.document().step);
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

void close_lesson(Session& session) {
  session.navigate([](Document& document) { document.mode = ScreenMode::explore; });
  session.edit("close the lesson", [](Document& document) {
    document.lesson.clear();
    document.step = 0;
  });
}

}  // namespace ps::gui
