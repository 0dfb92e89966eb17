#pragma once
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>

#include "base/progress.h"

namespace ps {

/// Shared by the thread of a long study and its observers. All members may be called from any thread.
class StudyControl {
 public:
  /// For the renders inside the study; a stop asked for here ends the study too.
  Progress& progress() { return progress_; }
  void cancel() {
    progress_.request_stop();
    set_paused(false);
  }
  void set_paused(bool paused) {
    {
      const std::lock_guard lock(mutex_);
      paused_ = paused;
    }
    changed_.notify_all();
  }
  bool paused() const {
    const std::lock_guard lock(mutex_);
    return paused_;
  }
  /// Called by the study between two runs: waits while paused, throws Cancelled when asked to stop.
  void wait_here() {
    std::unique_lock lock(mutex_);
    while (paused_ && !progress_.stop_requested()) changed_.wait_for(lock, std::chrono::milliseconds(100));
    progress_.check();
  }

 private:
  Progress progress_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  bool paused_ = false;
};

/// How far a study is.
struct StudyStatus {
  int done = 0, total = 0;   ///< runs
  double seconds_left = -1;  ///< estimated from the runs so far; negative = not known yet
};

}  // namespace ps
