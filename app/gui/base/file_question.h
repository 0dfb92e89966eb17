#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace ps::gui {

/// What becomes of the file that is asked for.
enum class FileUse { open, save };

/// The file that was named, and the words that named it: a name that is not a file may mean something else.
struct FileAnswer {
  std::filesystem::path path;  ///< absolute
  std::string typed;
};

/// A question for a file.
struct FileQuestion {
  std::string title;  ///< of the dialog: "Save the chart"
  FileUse use = FileUse::save;
  std::vector<std::string> extensions;  ///< of the files that are listed, with their dots
  std::string hint;                     ///< in the line while it is empty
  std::string suggestion = {};          ///< what the line begins with
  std::function<void(const FileAnswer&)> answer;
};

}  // namespace ps::gui
