#include "base/atomic_file.h"

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fmt/format.h>

#include "base/check.h"

namespace ps {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, std::string_view what) {
  throw InputError(fmt::format("{}: {}", path.string(), what));
}

[[noreturn]] void fail_with_errno(const std::filesystem::path& path, std::string_view what, int error) {
  fail(path, fmt::format("{} ({})", what, std::generic_category().message(error)));
}

/// A name beside `path` that no other thread or process uses.
std::filesystem::path temporary_beside(const std::filesystem::path& path) {
  static std::atomic<unsigned> counter{0};
  auto name = path;
  name += fmt::format(".{}-{}.tmp", getpid(), counter.fetch_add(1));
  return name;
}

/// Removes the file at the end of the scope unless it was kept.
class Temporary {
 public:
  explicit Temporary(std::filesystem::path path) : path_(std::move(path)) {}
  ~Temporary() {
    std::error_code ignored;
    if (!kept_) std::filesystem::remove(path_, ignored);
  }
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;
  const std::filesystem::path& path() const { return path_; }
  void keep() { kept_ = true; }

 private:
  std::filesystem::path path_;
  bool kept_ = false;
};

/// The content of an existing file's mode, or what a new file would get.
mode_t mode_for(const std::filesystem::path& path) {
  constexpr mode_t new_file = 0666;  // less the umask, applied by open()
  struct stat found {};
  return stat(path.c_str(), &found) == 0 ? found.st_mode & 0777 : new_file;
}

/// Writes and flushes; returns 0 or an errno.
int write_all(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = write(file, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return 0;
}

}  // namespace

void write_file_atomically(const std::filesystem::path& path, std::string_view bytes) {
  std::error_code error;
  const auto folder = path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
  if (!std::filesystem::exists(folder, error)) fail(path, fmt::format("the folder {} does not exist", folder.string()));
  if (!std::filesystem::is_directory(folder, error)) fail(path, fmt::format("{} is not a folder", folder.string()));
  if (std::filesystem::is_directory(path, error)) fail(path, "is a folder, expected a file name");

  // A link stays a link: what it points to is replaced.
  const auto target = std::filesystem::is_symlink(path, error) ? std::filesystem::weakly_canonical(path, error) : path;
  Temporary temporary(temporary_beside(error ? path : target));
  const int file = open(temporary.path().c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode_for(target));
  if (file < 0) fail_with_errno(path, "cannot be written", errno);
  int failure = write_all(file, bytes);
  if (close(file) != 0 && failure == 0) failure = errno;
  if (failure != 0) fail_with_errno(path, "could not be written to the end", failure);
  if (std::rename(temporary.path().c_str(), target.c_str()) != 0) fail_with_errno(path, "cannot be replaced", errno);
  temporary.keep();
}

std::string read_whole_file(const std::filesystem::path& path, std::uintmax_t max_bytes) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) fail(path, "no such file");
  if (std::filesystem::is_directory(status)) fail(path, "is a folder, expected a file");
  if (!std::filesystem::is_regular_file(status)) fail(path, "is not a regular file");
  const auto size = std::filesystem::file_size(path, error);
  if (error) fail(path, error.message());
  if (size > max_bytes) fail(path, fmt::format("has {} bytes, expected at most {}", size, max_bytes));

  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rbe"), &std::fclose);
  if (!file) fail_with_errno(path, "cannot be read", errno);
  std::string bytes(static_cast<std::size_t>(size), '\0');
  bytes.resize(std::fread(bytes.data(), 1, bytes.size(), file.get()));
  if (std::ferror(file.get()) != 0) fail_with_errno(path, "cannot be read", errno);
  return bytes;
}

}  // namespace ps
