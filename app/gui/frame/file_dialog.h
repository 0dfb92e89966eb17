#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "gui/base/file_question.h"

namespace ps::gui {

/// Asks for a path: a list of the folder's files, and a line to type into. The only dialog that waits for an answer.
class FileDialog {
 public:
  void ask(FileQuestion question);
  /// Draws the dialog if it is open, and gives the file to its caller once it is chosen.
  void draw();

 private:
  void list_folder(std::optional<std::filesystem::path>& chosen);
  FileQuestion question_;
  std::filesystem::path folder_;
  std::string typed_;
  bool wanted_ = false;
  int asked_ = 0;  ///< how often
};

}  // namespace ps::gui
