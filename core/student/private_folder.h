#pragma once
#include <filesystem>

namespace ps {

/// An empty folder that only this user can list, below that for temporary files; removed with the object.
class PrivateFolder {
 public:
  /// Throws InputError when there can be none.
  PrivateFolder();
  ~PrivateFolder();
  PrivateFolder(const PrivateFolder&) = delete;
  PrivateFolder& operator=(const PrivateFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  /// Removes what lies in the folder `name` of it and makes it again, empty.
  std::filesystem::path empty_folder(const char* name) const;

 private:
  std::filesystem::path path_;
};

}  // namespace ps
