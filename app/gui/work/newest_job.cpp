#include "gui/work/newest_job.h"

#include <utility>

namespace ps::gui {

NewestJob::NewestJob() : thread_([this] { work(); }) {}

NewestJob::~NewestJob() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
    next_ = nullptr;
    if (running_) running_->request_stop();
  }
  changed_.notify_one();
  thread_.join();
}

void NewestJob::start(Job job) {
  {
    const std::lock_guard lock(mutex_);
    if (running_) running_->request_stop();
    next_ = std::move(job);
  }
  changed_.notify_one();
}

void NewestJob::cancel() {
  const std::lock_guard lock(mutex_);
  if (running_) running_->request_stop();
  next_ = nullptr;
}

bool NewestJob::busy() const {
  const std::lock_guard lock(mutex_);
  return running_ || next_;
}

double NewestJob::fraction() const {
  const std::lock_guard lock(mutex_);
  return running_ ? running_->fraction() : 0.0;
}

void NewestJob::work() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return ending_ || next_; });
    if (ending_) return;
    const Job job = std::exchange(next_, nullptr);
    const auto progress = std::make_shared<Progress>();
    running_ = progress;
    lock.unlock();
    try {
      job(*progress);
    } catch (const Cancelled&) {
      // The stop was asked for.
    }
    lock.lock();
    running_ = nullptr;
  }
}

}  // namespace ps::gui
