#pragma once
#include <filesystem>
#include <optional>
#include <string>

namespace ps::gui {

/// A file that holds what is open as long as the program runs. One that is found although its program has ended tells
/// of a crash.
class Autosave {
 public:
  /// An empty folder saves nothing. The folder is made when it is first needed.
  explicit Autosave(std::filesystem::path folder);
  ~Autosave();
  Autosave(const Autosave&) = delete;
  Autosave& operator=(const Autosave&) = delete;

  /// What a program that did not end cleanly had open. The file is gone afterwards.
  std::optional<std::string> take_left_behind();
  /// Saves `text` unless it is what was saved last. Failing to is no reason to bother anyone.
  void save(const std::string& text);

 private:
  std::filesystem::path own_file() const;
  std::filesystem::path folder_;
  std::string saved_;
};

}  // namespace ps::gui
