#pragma once
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "gui/session/document_store.h"
#include "gui/work/file_watch.h"
#include "gui/work/newest_job.h"

namespace ps::gui {

/// What the session needs from the window around it. All may be empty.
struct SessionHost {
  std::function<void()> wake;  ///< from any thread: there is something new
  std::function<std::string(const std::string& key)> remembered;
  std::function<void(const std::string& key, std::string lines)> remember_lines;  ///< a list, one entry a line
};

/// A document that was loaded, or why it could not be.
struct Loaded {
  std::string name;
  std::optional<Document> document;
  std::string error;
  std::string error_file;  ///< the one in which the error is, if it is in one
  LoadReason reason = LoadReason::open;
};

/// The file of that name could not be read, and why.
Loaded failed_load(const std::string& name, const std::exception& error);

/// Reads documents in the background, watches their files, and keeps the list of the recent ones.
class Loader {
 public:
  explicit Loader(SessionHost host);

  /// Loads by `make`, in place of what is being loaded.
  void load(const std::string& name, std::function<Document()> make, LoadReason reason);
  bool loading() const { return !cancelled_ && job_.busy(); }
  /// What is being loaded.
  const std::string& name() const { return name_; }
  /// Drops what is being loaded. Reading a file ends some time later, unseen.
  void cancel();
  bool has_news() const;
  /// What has come since the last call.
  std::optional<Loaded> take();

  /// From now on these files are watched; `take_changed` names those that were written since it was called last.
  void watch(const std::vector<std::filesystem::path>& files) { watch_.watch(files); }
  std::vector<std::filesystem::path> take_changed() { return watch_.take_changed(); }

  const std::vector<std::string>& recent() const { return recent_; }
  /// Puts a file in front of the recent ones, so that it is offered.
  void note_recent(const std::string& name);

 private:
  SessionHost host_;
  std::string name_;
  bool cancelled_ = false;
  std::vector<std::string> recent_;
  mutable std::mutex mutex_;  // of loaded_
  std::optional<Loaded> loaded_;

  // Last, so that their threads end before what they use.
  FileWatch watch_;
  NewestJob job_;
};

}  // namespace ps::gui
