#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "gui/base/file_question.h"

namespace ps::gui {

/// Asks for a path: a list of the folder's files, and a line to type into. The only dialog that waits for an answer.
class FileDialog {
 public:
  FileDialog();
  void ask(FileQuestion question);
  /// Draws the dialog if it is open, and gives the file to its caller once it is chosen.
  void draw();
  /// The folder of the file that was chosen last, or at first the working folder.
  const std::filesystem::path& folder() const { return folder_; }
  /// Begins in this folder, where there still is one, and hands each later one to `keep`.
  void keep_folder(const std::filesystem::path& folder, std::function<void(const std::string&)> keep);

 private:
  void go_to(const std::filesystem::path& folder);
  void list_folder(std::optional<std::filesystem::path>& chosen);
  FileQuestion question_;
  std::filesystem::path folder_;
  std::function<void(const std::string&)> keep_;
  std::string typed_;
  bool wanted_ = false;
  int asked_ = 0;  ///< how often
};

}  // namespace ps::gui
