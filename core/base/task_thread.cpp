#include "base/task_thread.h"

#include <exception>

#include "base/check.h"
#include "base/stop.h"

namespace ps {

TaskThread::TaskThread() : thread_([this] { work(); }) {}

TaskThread::~TaskThread() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void TaskThread::run(const std::function<void()>& task) {
  PS_ASSERT(std::this_thread::get_id() != thread_.get_id(), "a task that waits for another of its thread never ends");
  std::exception_ptr failure;
  bool done = false;
  const Progress* const stop = current_stop();
  std::unique_lock lock(mutex_);
  tasks_.emplace_back([&] {
    const StopScope scope(stop);
    try {
      task();
    } catch (...) {
      failure = std::current_exception();
    }
    const std::lock_guard finished(mutex_);
    done = true;
  });
  changed_.notify_all();
  changed_.wait(lock, [&] { return done; });
  if (failure) std::rethrow_exception(failure);
}

void TaskThread::work() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [&] { return ending_ || !tasks_.empty(); });
    if (tasks_.empty()) return;
    const std::function<void()> task = std::move(tasks_.front());
    tasks_.pop_front();
    lock.unlock();
    task();
    changed_.notify_all();
    lock.lock();
  }
}

}  // namespace ps
