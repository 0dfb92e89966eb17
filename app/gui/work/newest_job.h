#pragma once
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>

#include "base/progress.h"

namespace ps::gui {

/// One background thread that works on the newest of the jobs it is given: a new job stops the running one and takes
/// the place of the waiting one. Nothing here blocks the caller except the destructor, which asks the running job to
/// stop and waits for it.
class NewestJob {
 public:
  /// Runs on the background thread. It should look at its Progress often; it may throw Cancelled, and nothing else.
  using Job = std::function<void(Progress&)>;

  NewestJob();
  ~NewestJob();
  NewestJob(const NewestJob&) = delete;
  NewestJob& operator=(const NewestJob&) = delete;

  /// Stops the running job, drops the waiting one, and runs `job` next.
  void start(Job job);
  /// Stops the running job and drops the waiting one.
  void cancel();
  /// A job is running or waiting.
  bool busy() const;
  /// Share of the running job that is done, in [0, 1]; 0 when there is none.
  double fraction() const;

 private:
  void work();

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  Job next_;
  std::shared_ptr<Progress> running_;
  bool ending_ = false;
  std::thread thread_;
};

}  // namespace ps::gui
