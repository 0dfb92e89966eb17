#pragma once
#include "base/progress.h"

namespace ps {

namespace detail {
inline thread_local const Progress* stop_of_thread = nullptr;
}

/// The progress that may stop what this thread does now; null = none may.
inline const Progress* current_stop() { return detail::stop_of_thread; }

/// While it lives, check_stop() on this thread, and inside every parallel_for() that it calls, listens to `progress`.
/// For what is built deep inside a picture (accelerators, tessellations), which may take longer than the picture
/// itself.
class StopScope {
 public:
  explicit StopScope(const Progress* progress) : before_(detail::stop_of_thread) { detail::stop_of_thread = progress; }
  ~StopScope() { detail::stop_of_thread = before_; }
  StopScope(const StopScope&) = delete;
  StopScope& operator=(const StopScope&) = delete;

 private:
  const Progress* before_;
};

/// Throws Cancelled if the thread's StopScope was asked to stop; called about once for each thousand steps.
inline void check_stop() {
  if (const Progress* progress = current_stop()) progress->check();
}

}  // namespace ps
