#include "base/atomic_file.h"

#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <ctime>
#include <string>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fmt/format.h>

#include "base/check.h"
#include "base/output_target.h"
#include "base/temporary_files.h"

namespace ps {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail_to_write(const fs::path& path, std::string_view what, int error) {
  throw InputError(fmt::format("{}: {} ({})", path.string(), what, std::generic_category().message(error)));
}

/// A file descriptor that is closed at the end of the scope.
class OpenFile {
 public:
  explicit OpenFile(int descriptor) : descriptor_(descriptor) {}
  ~OpenFile() { close(); }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  int get() const { return descriptor_; }
  /// 0 or an errno.
  int close() {
    const int descriptor = std::exchange(descriptor_, -1);
    return descriptor >= 0 && ::close(descriptor) != 0 ? errno : 0;
  }

 private:
  int descriptor_;
};

std::atomic<int> temporary_files{0};
static_assert(std::atomic<int>::is_always_lock_free, "signal handlers read it");

/// A new file beside the one that it is to replace; removed at the end of the scope unless it took the other's name.
class TemporaryFile {
 public:
  /// The name is short and has no part of the other's, which may be as long as the system allows. Names that are taken,
  /// such as those of a process of the same number in another container, are passed over.
  TemporaryFile(const fs::path& folder, mode_t mode) {
    static std::atomic<unsigned> counter{0};
    ++temporary_files;
    constexpr int most_tries = 1000;
    for (int tries = 0; tries < most_tries; ++tries) {
      path_ = folder / fmt::format(".pixelscope-{}-{}.tmp", getpid(), counter.fetch_add(1));
      descriptor_ = open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
      if (descriptor_ >= 0 || errno != EEXIST) return;
    }
  }
  ~TemporaryFile() {
    if (descriptor_ >= 0 && !renamed_) unlink(path_.c_str());
    --temporary_files;
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  /// -1 if it could not be made; errno says why.
  int descriptor() const { return descriptor_; }
  /// 0 or an errno.
  int take_name(const fs::path& name) {
    renamed_ = std::rename(path_.c_str(), name.c_str()) == 0;
    return renamed_ ? 0 : errno;
  }

 private:
  fs::path path_;
  int descriptor_ = -1;
  bool renamed_ = false;
};

/// Returns 0 or an errno.
int write_all(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = write(file, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    if (written == 0) return EIO;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return 0;
}

/// Waits until the disk has it. Returns 0 or an errno; a file system that cannot do that is not a failure.
int sync_to_disk(int file) {
  while (fsync(file) != 0) {
    if (errno == EINTR) continue;
    return errno == EINVAL || errno == ENOTSUP || errno == EROFS ? 0 : errno;
  }
  return 0;
}

void replace_file(const fs::path& path, const OutputTarget& target, std::string_view bytes, Durability durability) {
  constexpr mode_t new_file = 0666;  // minus the umask, which open() applies
  const fs::path folder = target.path.has_parent_path() ? target.path.parent_path() : fs::path(".");
  TemporaryFile temporary(folder, target.exists ? target.mode : new_file);
  if (temporary.descriptor() < 0) fail_to_write(path, "cannot be written", errno);
  OpenFile file(temporary.descriptor());
  if (target.exists) {
    // Only the superuser may give files away: a file of somebody else's then belongs to the writer.
    if (fchown(file.get(), target.owner, target.group) != 0)
      static_cast<void>(fchown(file.get(), static_cast<uid_t>(-1), target.group) == 0);
    static_cast<void>(fchmod(file.get(), target.mode) == 0);  // not what the umask left of it
  }
  int failure = write_all(file.get(), bytes);
  if (failure == 0 && durability == Durability::synced) failure = sync_to_disk(file.get());
  if (const int closing = file.close(); failure == 0) failure = closing;
  if (failure != 0) fail_to_write(path, "could not be written to the end", failure);
  if (const int renaming = temporary.take_name(target.path)) fail_to_write(path, "cannot be replaced", renaming);
  if (durability == Durability::quick) return;
  const OpenFile directory(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (directory.get() >= 0) sync_to_disk(directory.get());  // the file is in its place, whatever comes out
}

/// Keeps SIGPIPE away from this thread: a reader that has gone is an error of the write, not the end of the program.
class WithoutPipeSignal {
 public:
  WithoutPipeSignal() {
    sigemptyset(&pipe_);
    sigaddset(&pipe_, SIGPIPE);
    sigset_t pending;
    sigemptyset(&pending);
    sigpending(&pending);
    was_pending_ = sigismember(&pending, SIGPIPE) == 1;
    pthread_sigmask(SIG_BLOCK, &pipe_, &before_);
  }
  ~WithoutPipeSignal() {
    const timespec at_once{};
    if (!was_pending_) sigtimedwait(&pipe_, nullptr, &at_once);
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }
  WithoutPipeSignal(const WithoutPipeSignal&) = delete;
  WithoutPipeSignal& operator=(const WithoutPipeSignal&) = delete;

 private:
  sigset_t pipe_{}, before_{};
  bool was_pending_ = false;
};

/// Opens a device or a pipe for writing. A pipe without a reader is tried again for a while; -1 with errno.
int open_to_write_into(const fs::path& path) {
  constexpr auto longest_wait = std::chrono::seconds(10);
  constexpr int pause_milliseconds = 20;
  const auto end = std::chrono::steady_clock::now() + longest_wait;
  int file = -1;
  while ((file = open(path.c_str(), O_WRONLY | O_TRUNC | O_NONBLOCK | O_NOCTTY | O_CLOEXEC)) < 0) {
    const int error = errno;
    if (error != EINTR && (error != ENXIO || std::chrono::steady_clock::now() > end)) {
      errno = error;
      return -1;
    }
    poll(nullptr, 0, pause_milliseconds);
  }
  if (const int flags = fcntl(file, F_GETFL); flags >= 0) fcntl(file, F_SETFL, flags & ~O_NONBLOCK);
  return file;
}

void write_into(const fs::path& path, std::string_view bytes) {
  const WithoutPipeSignal quiet;
  OpenFile file(open_to_write_into(path));
  if (file.get() < 0 && errno == ENXIO)
    throw InputError(fmt::format("{}: no program reads from this pipe", path.string()));
  if (file.get() < 0) fail_to_write(path, "cannot be written", errno);
  int failure = write_all(file.get(), bytes);
  if (const int closing = file.close(); failure == 0) failure = closing;
  if (failure != 0) fail_to_write(path, "could not be written to the end", failure);
}

void write_to_stream(const fs::path& path, int stream, std::string_view bytes) {
  const WithoutPipeSignal quiet;
  int failure = std::fflush(stream == STDOUT_FILENO ? stdout : stderr) == 0 ? 0 : errno;
  if (failure == 0) failure = write_all(stream, bytes);
  if (failure != 0) fail_to_write(path, "could not be written to the end", failure);
}

}  // namespace

bool has_temporary_files() { return temporary_files > 0; }

void write_file_atomically(const fs::path& path, std::string_view bytes, Durability durability) {
  const OutputTarget target = output_target(path);
  switch (target.way) {
  case OutputTarget::Way::replace:
    return replace_file(path, target, bytes, durability);
  case OutputTarget::Way::into:
    return write_into(path, bytes);
  case OutputTarget::Way::stream:
    return write_to_stream(path, target.stream, bytes);
  }
}

}  // namespace ps
