#include "gui/work/file_watch.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace ps::gui {
namespace {

constexpr std::chrono::milliseconds between_looks{250};

}  // namespace

FileWatch::FileWatch(std::function<void()> wake) : wake_(std::move(wake)), thread_([this] { work(); }) {}

FileWatch::~FileWatch() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  ending_changed_.notify_one();
  thread_.join();
}

std::optional<FileWatch::State> FileWatch::look(const std::filesystem::path& path) {
  std::error_code error;
  State state;
  state.time = std::filesystem::last_write_time(path, error);
  if (error) return {};
  state.size = std::filesystem::file_size(path, error);
  if (error) return {};
  return state;
}

void FileWatch::watch(const std::vector<std::filesystem::path>& files) {
  const std::lock_guard lock(mutex_);
  // What is watched already stays as it was last known: a change made while its reader was at work is not missed.
  const auto before = std::exchange(files_, {});
  for (const auto& path : files) {
    const auto old = std::find_if(before.begin(), before.end(), [&](const auto& file) { return file.path == path; });
    if (old != before.end()) {
      files_.push_back(*old);
      continue;
    }
    const auto now = look(path);
    files_.push_back({path, now, now});
  }
}

std::vector<std::filesystem::path> FileWatch::take_changed() {
  const std::lock_guard lock(mutex_);
  return std::exchange(changed_, {});
}

void FileWatch::work() {
  std::unique_lock lock(mutex_);
  while (!ending_changed_.wait_for(lock, between_looks, [this] { return ending_; })) {
    bool found = false;
    for (auto& file : files_) {
      const auto now = look(file.path);
      // Twice the same means that the writer has finished.
      if (now && now != file.known && now == file.last_seen) {
        file.known = now;
        changed_.push_back(file.path);
        found = true;
      }
      file.last_seen = now;
    }
    if (found && wake_) wake_();
  }
}

}  // namespace ps::gui
