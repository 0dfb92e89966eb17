#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace ps::test {

/// What a finished program left.
struct ProgramResult {
  int status = -1;  ///< exit status; 128 + n when signal n ended it
  std::string out, err;
};

/// Runs pixelscope-cli with these arguments and waits for it.
ProgramResult run_cli(const std::vector<std::string>& arguments);
/// The same; fails the test unless the program succeeds.
ProgramResult run_cli_well(const std::vector<std::string>& arguments);

/// An empty folder of this test, removed with the object.
class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  /// Path of a file in the folder.
  std::string file(const std::string& name) const { return (path_ / name).string(); }
  /// Writes a file there, in a folder of it if the name has one, and gives its path.
  std::string write(const std::string& name, const std::string& text) const;
  /// Names of what lies in the folder, sorted.
  std::vector<std::string> names() const;

 private:
  std::filesystem::path path_;
};

}  // namespace ps::test
