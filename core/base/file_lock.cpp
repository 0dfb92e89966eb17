#include "base/file_lock.h"

#include <cerrno>
#include <system_error>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <fmt/format.h>

#include "base/check.h"

namespace ps {

std::optional<FileLock> FileLock::try_lock(const std::filesystem::path& path) {
  // Not blocking: a named pipe of that name would wait for a reader.
  const int file = open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NONBLOCK, 0666);
  if (file < 0)
    throw InputError(fmt::format("{}: cannot be locked ({})", path.string(), std::generic_category().message(errno)));
  FileLock lock(file);
  lock.guards_ = flock(file, LOCK_EX | LOCK_NB) == 0;
  if (!lock.guards_ && errno == EWOULDBLOCK) return {};
  return lock;
}

std::optional<FileLock> FileLock::lock_within(const std::filesystem::path& path, std::chrono::milliseconds patience) {
  // Asks again and again: a call that blocks could not be given up.
  constexpr std::chrono::milliseconds pause{5};
  const auto end = std::chrono::steady_clock::now() + patience;
  while (true) {
    if (auto lock = try_lock(path)) return lock;
    if (std::chrono::steady_clock::now() >= end) return {};
    std::this_thread::sleep_for(pause);
  }
}

std::filesystem::path FileLock::beside(std::filesystem::path file) { return file += ".lock"; }

FileLock::FileLock(FileLock&& other) noexcept : file_(std::exchange(other.file_, -1)), guards_(other.guards_) {}

FileLock& FileLock::operator=(FileLock&& other) noexcept {
  std::swap(file_, other.file_);
  std::swap(guards_, other.guards_);
  return *this;
}

FileLock::~FileLock() {
  if (file_ >= 0) close(file_);
}

}  // namespace ps
