#pragma once
#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace ps::gui {

/// Polls a few files on a thread of its own and reports when one of them was written. A file that is
/// still growing, or that is gone for a moment while an editor replaces it, is waited for.
class FileWatch {
 public:
  /// `wake` is called from the watching thread when a file was written; it must not block.
  explicit FileWatch(std::function<void()> wake);
  ~FileWatch();
  FileWatch(const FileWatch&) = delete;
  FileWatch& operator=(const FileWatch&) = delete;

  /// Watches these files instead of the ones before: from their present state on, or, where they were watched already,
  /// from the one last known.
  void watch(const std::vector<std::filesystem::path>& files);
  /// The watched files that were written since the last call.
  std::vector<std::filesystem::path> take_changed();

 private:
  struct State {
    std::filesystem::file_time_type time;
    std::uintmax_t size = 0;
    bool operator==(const State&) const = default;
  };
  struct File {
    std::filesystem::path path;
    std::optional<State> known, last_seen;  // absent = there is no such file
  };
  static std::optional<State> look(const std::filesystem::path& path);
  void work();

  const std::function<void()> wake_;
  std::mutex mutex_;
  std::condition_variable ending_changed_;
  bool ending_ = false;
  std::vector<std::filesystem::path> changed_;
  std::vector<File> files_;
  std::thread thread_;
};

}  // namespace ps::gui
