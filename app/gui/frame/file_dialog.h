#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

namespace ps::gui {

enum class FilePurpose {
  open_scene,
  open_picture,     ///< as the reference of a chart
  compare_picture,  ///< as B
  save_picture,
  save_scene,
  save_chart,
  save_permalink,
  save_story,
  save_space,
  save_microscope
};

/// Asks for a path: a list of the folder's files, and a line to type into. The only dialog that waits for an answer.
class FileDialog {
 public:
  void ask(FilePurpose purpose, const std::string& suggestion = {});
  /// Draws the dialog if it is open; the chosen path once it is.
  struct Answer {
    FilePurpose purpose = FilePurpose::open_scene;
    std::filesystem::path path;
  };
  std::optional<Answer> draw();
  /// What stands in the line.
  const std::string& typed() const { return typed_; }

 private:
  void list_folder(std::optional<Answer>& answer);
  FilePurpose purpose_ = FilePurpose::open_scene;
  std::filesystem::path folder_;
  std::string typed_;
  bool wanted_ = false;
  int asked_ = 0;  ///< how often
};

}  // namespace ps::gui
