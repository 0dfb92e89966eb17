#pragma once
#include <chrono>
#include <filesystem>
#include <optional>

namespace ps {

/// Holds a file locked against other programs and other FileLocks of this one, as long as the object lives. A lock goes
/// with the program that holds it, however it ends, so none is ever stale; over a network the file system passes it on.
class FileLock {
 public:
  /// Creates the file if it is missing; it stays when the lock goes. nullopt if another holds it. On a file system
  /// without locks it excludes no other process. Throws InputError if the file cannot be made or opened.
  static std::optional<FileLock> try_lock(const std::filesystem::path& path);
  /// The same, but waits up to `patience` until the other lets it go.
  static std::optional<FileLock> lock_within(const std::filesystem::path& path, std::chrono::milliseconds patience);

  /// The file to lock in place of `file`: its name with ".lock" behind it. A file that is replaced as a whole when it
  /// is written cannot be locked itself.
  static std::filesystem::path beside(std::filesystem::path file);

  FileLock(FileLock&& other) noexcept;
  FileLock& operator=(FileLock&& other) noexcept;
  ~FileLock();

  /// Whether the file system has locks: without, having this object does not exclude others.
  bool guards() const { return guards_; }

 private:
  explicit FileLock(int file) : file_(file) {}
  int file_ = -1;  ///< descriptor; -1 = moved away
  bool guards_ = false;
};

}  // namespace ps
