#include "student/private_folder.h"

#include <fmt/format.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>
#include <vector>

#include "base/check.h"

namespace ps {
namespace {

/// Lets this user read and change a folder and all folders in it, as far as it is theirs.
void open_folders(const std::filesystem::path& folder) {
  std::error_code ignored;
  std::vector<std::filesystem::path> waiting{folder};
  while (!waiting.empty()) {
    const std::filesystem::path place = std::move(waiting.back());
    waiting.pop_back();
    std::filesystem::permissions(place, std::filesystem::perms::owner_all, std::filesystem::perm_options::add, ignored);
    for (const auto& entry : std::filesystem::directory_iterator(place, ignored))
      if (entry.symlink_status(ignored).type() == std::filesystem::file_type::directory)
        waiting.push_back(entry.path());
  }
}

}  // namespace

PrivateFolder::PrivateFolder() {
  std::error_code error;
  std::string name = (std::filesystem::temp_directory_path(error) / "pixelscope-XXXXXX").string();
  if (error || !mkdtemp(name.data()))
    throw InputError(
        fmt::format("no temporary folder can be made: {}", error ? error.message() : std::strerror(errno)));
  path_ = std::filesystem::canonical(name, error);
  if (error) path_ = name;
  // A program of root's gets another user's rights, who must come to what lies inside by name.
  constexpr mode_t way_through = 0711;
  if (geteuid() == 0) chmod(path_.c_str(), way_through);
}

PrivateFolder::~PrivateFolder() {
  std::error_code error;
  std::filesystem::remove_all(path_, error);
  if (!error) return;
  open_folders(path_);  // a program may have taken its own rights to them away
  std::filesystem::remove_all(path_, error);
}

std::filesystem::path PrivateFolder::empty_folder(const char* name) const {
  std::error_code error;
  std::filesystem::path folder = path_ / name;
  std::filesystem::remove_all(folder, error);
  std::filesystem::create_directory(folder, error);
  if (error) throw InputError(fmt::format("{} cannot be made: {}", folder.string(), error.message()));
  return folder;
}

}  // namespace ps
