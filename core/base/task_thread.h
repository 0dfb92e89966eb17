#pragma once
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

namespace ps {

/// A thread that carries out tasks one after the other, in the order in which they came. For what belongs to one
/// thread, such as the context of a graphics driver.
class TaskThread {
 public:
  TaskThread();
  /// Carries out what was asked for, then ends the thread.
  ~TaskThread();
  TaskThread(const TaskThread&) = delete;
  TaskThread& operator=(const TaskThread&) = delete;

  /// Carries out the task on the thread and returns when it has ended. What the task throws is thrown here; it listens
  /// to the caller's StopScope. From any thread but its own.
  void run(const std::function<void()>& task);

 private:
  void work();

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::function<void()>> tasks_;
  bool ending_ = false;
  std::thread thread_;  ///< the last member, for it uses the others from its beginning
};

}  // namespace ps
