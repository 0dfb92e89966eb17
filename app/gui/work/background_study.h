#pragma once
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "base/check.h"
#include "base/failure_text.h"
#include "gui/work/newest_job.h"
#include "study/control.h"

namespace ps::gui {

enum class StudyState { none, running, paused, done, cancelled, failed };

/// One long study at a time in the background, and the newest of what it has found. All members are for the window's
/// thread and return at once; the destructor stops the study and waits until it has ended.
template <class Found>
class BackgroundStudy {
 public:
  /// Called by the study whenever there is more to see. What is handed over is never changed again.
  using Publish = std::function<void(std::shared_ptr<const Found>, const StudyStatus&)>;
  /// May throw Cancelled, and InputError, whose text becomes message().
  using Work = std::function<void(StudyControl&, const Publish&)>;

  /// `wake` is called from another thread when there is something new; it must not block.
  explicit BackgroundStudy(std::function<void()> wake) : wake_(std::move(wake)) {}
  ~BackgroundStudy() { cancel(); }

  /// Stops the study that runs and begins this one.
  void start(Work work) {
    cancel();
    const auto run = std::make_shared<Run>();
    {
      const std::lock_guard lock(mutex_);
      run_ = run;
    }
    job_.start([this, run, work = std::move(work)](Progress&) { carry_out(*run, work); });
  }
  void cancel() {
    if (running()) run_->control.cancel();
  }
  /// Waits between two of its runs until it is resumed.
  void set_paused(bool paused) {
    if (!running()) return;
    run_->paused = paused;
    run_->control.set_paused(run_->paused || run_->held);
  }
  /// The same without being shown as paused: the views render, and neither shall disturb the other.
  void set_held(bool held) {
    if (!running() || run_->held == held) return;
    run_->held = held;
    run_->control.set_paused(run_->paused || run_->held);
  }

  StudyState state() const {
    const std::lock_guard lock(mutex_);
    if (!run_) return StudyState::none;
    return run_->state == StudyState::running && run_->paused ? StudyState::paused : run_->state;
  }
  /// Running or paused.
  bool running() const {
    const std::lock_guard lock(mutex_);
    return run_ && run_->state == StudyState::running;
  }
  /// The newest of the study that was started last; nullptr before it has anything.
  std::shared_ptr<const Found> found() const {
    const std::lock_guard lock(mutex_);
    return run_ ? run_->found : nullptr;
  }
  StudyStatus status() const {
    const std::lock_guard lock(mutex_);
    return run_ ? run_->status : StudyStatus{};
  }
  /// Why it failed.
  std::string message() const {
    const std::lock_guard lock(mutex_);
    return run_ ? run_->message : "";
  }
  /// Share of what is being rendered now, in [0, 1].
  double fraction_of_render() const {
    const std::lock_guard lock(mutex_);
    return run_ ? run_->control.progress().fraction() : 0;
  }

 private:
  struct Run {
    StudyControl control;
    bool paused = false, held = false;  // of the window's thread
    StudyState state = StudyState::running;
    std::shared_ptr<const Found> found;
    StudyStatus status;
    std::string message;
  };

  void carry_out(Run& run, const Work& work) {
    StudyState ended = StudyState::done;
    std::string message;
    try {
      work(run.control, [&](std::shared_ptr<const Found> found, const StudyStatus& status) {
        {
          const std::lock_guard lock(mutex_);
          run.found = std::move(found);
          run.status = status;
        }
        if (wake_) wake_();
      });
    } catch (const Cancelled&) {
      ended = StudyState::cancelled;
    } catch (const std::exception& error) {
      ended = StudyState::failed;
      message = failure_text(error);
    }
    {
      const std::lock_guard lock(mutex_);
      run.state = ended;
      run.message = std::move(message);
    }
    if (wake_) wake_();
  }

  const std::function<void()> wake_;
  mutable std::mutex mutex_;  // guards state, found, status and message of the run, and which run it is
  std::shared_ptr<Run> run_;

  NewestJob job_;  // last, so that its thread ends before what it uses
};

/// "12 of 40 runs, 8 s left"
std::string status_text(const StudyStatus& status, std::string_view unit);

}  // namespace ps::gui
