#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/file_lock.h"

namespace ps::gui {

/// What a program that did not end properly, or was ended from outside, had open.
struct LeftBehind {
  std::filesystem::path file;  ///< where it is kept from now on
  std::filesystem::file_time_type saved;
  std::string text;     ///< a permalink, unless `problem` says why it cannot be read
  std::string problem;  ///< "" if it was read
  /// It was restored, and that program ended before Autosave::outlived_start(): shown again, it would do so again.
  bool ended_at_once = false;
  bool ended_from_outside = false;  ///< by a log-out or a shutdown, without a fault
};

/// A file that holds what is open as long as the program runs: `open-HOST-PROCESS.permalink`, beside a lock file of the
/// same name, which other programs find locked as long as this one runs, also on other computers with the same home
/// folder. A file that is found unlocked was left behind by a program that did not end properly.
class Autosave {
 public:
  /// An empty folder saves nothing. The folder is made when it is first needed.
  explicit Autosave(std::filesystem::path folder);
  ~Autosave();
  Autosave(const Autosave&) = delete;
  Autosave& operator=(const Autosave&) = delete;

  /// What was left behind, the newest first. Each is moved to a name of its own, `left-behind-DATE.permalink`, where it
  /// stays until restore(); another call finds none of them.
  std::vector<LeftBehind> take_left_behind();
  /// This program shows that session: its file is removed as soon as this program has saved it as its own, with the
  /// mark that it was restored.
  void restore(const LeftBehind& session) {
    restored_ = session.file;
    marked_ = true;
  }
  /// Takes the mark of a restored session away: its screen can be drawn and worked with.
  void outlived_start();
  /// Saves `text` unless it is what was saved last. After a failure the next call tries again.
  void save(const std::string& text);
  /// Why the last save() failed; "" if it did not.
  const std::string& problem() const { return problem_; }
  /// Leaves the file when this object goes.
  void keep() { keep_ = true; }
  /// The same for a program that is ended from outside, with a mark that says so.
  void end_from_outside();

 private:
  bool find_own_name();
  std::filesystem::path with_ending(const char* ending) const;

  std::filesystem::path folder_;
  std::string name_;  ///< of the own files, without their ending; empty before the first save()
  std::optional<FileLock> lock_;
  std::string saved_, problem_;
  std::filesystem::path restored_;
  bool marked_ = false;  ///< in the lock file, as soon as there is one
  bool keep_ = false;
};

}  // namespace ps::gui
