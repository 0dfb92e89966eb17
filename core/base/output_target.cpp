#include "base/output_target.h"

#include <cerrno>
#include <optional>
#include <system_error>

#include <sys/stat.h>
#include <unistd.h>

#include <fmt/format.h>

#include "base/check.h"

namespace ps {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse_output(const fs::path& path, std::string_view reason) {
  throw InputError(fmt::format("{}: {}", path.string(), reason));
}

std::string reason_of(int error) { return std::generic_category().message(error); }

fs::path folder_of(const fs::path& path) { return path.has_parent_path() ? path.parent_path() : fs::path("."); }

/// Follows the symbolic links of `path` to a name that is not a link, which may be missing. nullopt for links below
/// /proc, which refer to files that are open already.
std::optional<fs::path> behind_links(const fs::path& path) {
  constexpr int most_links = 40;  // as many as Linux follows
  std::error_code error;
  fs::path at = path;
  for (int links = 0; fs::is_symlink(at, error); ++links) {
    if (links == most_links) refuse_output(path, "is a symbolic link that points to itself through other links");
    if (fs::weakly_canonical(folder_of(at), error).string().starts_with("/proc/")) return {};
    const fs::path next = fs::read_symlink(at, error);
    if (error) refuse_output(path, reason_of(error.value()));
    at = next.is_absolute() ? next : folder_of(at) / next;
  }
  return at;
}

/// The standard stream that is this very file.
std::optional<int> stream_that_is(const struct stat& file) {
  for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) {
    struct stat open {};
    if (fstat(stream, &open) == 0 && open.st_dev == file.st_dev && open.st_ino == file.st_ino) return stream;
  }
  return {};
}

void require_folder(const fs::path& path, const fs::path& folder) {
  std::error_code error;
  if (!fs::exists(folder, error)) refuse_output(path, fmt::format("the folder '{}' does not exist", folder.string()));
  if (!fs::is_directory(folder, error)) refuse_output(path, fmt::format("'{}' is not a folder", folder.string()));
  if (access(folder.c_str(), W_OK | X_OK) != 0)
    refuse_output(path, fmt::format("the folder '{}' cannot be written ({})", folder.string(), reason_of(errno)));
}

}  // namespace

OutputTarget output_target(const fs::path& path) {
  constexpr mode_t anybody_writes = 0222, permissions = 0777;
  struct stat file {};
  const bool found = stat(path.c_str(), &file) == 0;
  OutputTarget target;
  target.path = path;
  if (found) {
    if (S_ISDIR(file.st_mode)) refuse_output(path, "is a folder, expected a file name");
    if (S_ISBLK(file.st_mode)) refuse_output(path, "is a disk, expected a file name");
    if (S_ISSOCK(file.st_mode)) refuse_output(path, "is a socket, expected a file name");
    if (const auto stream = stream_that_is(file)) {
      target.way = OutputTarget::Way::stream;
      target.stream = *stream;
      return target;
    }
  } else if (errno != ENOENT && errno != ELOOP && errno != ENOTDIR) {
    refuse_output(path, fmt::format("cannot be written ({})", reason_of(errno)));
  }
  const auto end = behind_links(path);
  if (found && (!S_ISREG(file.st_mode) || !end)) {
    target.way = OutputTarget::Way::into;
    return target;
  }
  target.path = end.value_or(path);
  require_folder(path, folder_of(target.path));
  if (!found) return target;
  target.exists = true;
  target.mode = file.st_mode & permissions;
  target.owner = file.st_uid;
  target.group = file.st_gid;
  if ((file.st_mode & anybody_writes) == 0 || access(path.c_str(), W_OK) != 0)
    refuse_output(path, "is write-protected; change its permissions, or choose another name");
  return target;
}

}  // namespace ps
