#pragma once
#include <filesystem>
#include <string>

namespace ps::gui {

/// Where studies keep their results as they arrive, so that one that was cut off goes on where it was: a folder for
/// each, in the user's state folder.
class StudyFolder {
 public:
  /// Without `remember`, the folders are temporary and go with this object.
  explicit StudyFolder(bool remember);
  ~StudyFolder();
  StudyFolder(const StudyFolder&) = delete;
  StudyFolder& operator=(const StudyFolder&) = delete;

  /// The folder of the study that `key` describes; it need not exist.
  std::filesystem::path of(const std::string& key) const;
  /// For scenes that experiments bring along.
  std::filesystem::path scenes() const { return root_ / "scenes"; }
  /// Whether anything is kept there.
  static bool holds_results(const std::filesystem::path& folder);
  static void forget(const std::filesystem::path& folder);

 private:
  void remove_oldest() const;
  std::filesystem::path root_;
  bool temporary_ = false;
};

}  // namespace ps::gui
