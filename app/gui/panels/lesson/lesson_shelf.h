#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "engine/lesson.h"
#include "gui/session/session.h"
#include "gui/work/file_watch.h"

namespace ps::gui {

/// The lesson that the document names, read when it is first needed, and again when its file is saved.
class LessonShelf {
 public:
  /// `wake` may be called from any thread.
  LessonShelf(Session& session, std::function<void()> wake) : session_(session), wake_(std::move(wake)) {}

  /// The open lesson, or nullptr. What cannot be read becomes a message of the session, once.
  const Lesson* open();
  /// Once per frame: reads the open lesson anew if its file was saved since, and shows the step again. With an error in
  /// the file, which becomes a message, the lesson stays as it was.
  void update();
  /// Grows each time a lesson is read. What follows from open() is up to date while this is the same.
  int version() const { return version_; }

 private:
  void load();

  Session& session_;
  std::function<void()> wake_;
  std::string name_;
  std::optional<Lesson> lesson_;
  int version_ = 0;
  std::unique_ptr<FileWatch> watch_;  // since a lesson was first opened
};

/// Puts a step on the screen: its scene, settings, channels and pixel. One step of the history.
void go_to_step(Session& session, const std::string& lesson, int step);
/// The lesson before or after the open one, from its first step; the first lesson if none is open.
void move_lesson(Session& session, int by);
void close_lesson(Session& session);

}  // namespace ps::gui
