#include "gui/work/background_study.h"

#include "base/check.h"
#include "base/failure_text.h"

namespace ps::gui {

void BackgroundWork::start_any(AnyWork work) {
  cancel();
  const auto run = std::make_shared<Run>();
  {
    const std::lock_guard lock(mutex_);
    run_ = run;
  }
  job_.start([this, run, work = std::move(work)](Progress&) { carry_out(*run, work); });
}

void BackgroundWork::cancel() {
  if (running()) run_->control.cancel();
}

void BackgroundWork::set_paused(bool paused) {
  if (!running()) return;
  run_->paused = paused;
  run_->control.set_paused(run_->paused || run_->held);
}

void BackgroundWork::set_held(bool held) {
  if (!running() || run_->held == held) return;
  run_->held = held;
  run_->control.set_paused(run_->paused || run_->held);
}

StudyState BackgroundWork::state() const {
  const std::lock_guard lock(mutex_);
  if (!run_) return StudyState::none;
  return run_->state == StudyState::running && run_->paused ? StudyState::paused : run_->state;
}

bool BackgroundWork::running() const {
  const std::lock_guard lock(mutex_);
  return run_ && run_->state == StudyState::running;
}

std::shared_ptr<const void> BackgroundWork::found_any() const {
  const std::lock_guard lock(mutex_);
  return run_ ? run_->found : nullptr;
}

StudyStatus BackgroundWork::status() const {
  const std::lock_guard lock(mutex_);
  return run_ ? run_->status : StudyStatus{};
}

std::string BackgroundWork::message() const {
  const std::lock_guard lock(mutex_);
  return run_ ? run_->message : "";
}

double BackgroundWork::fraction_of_render() const {
  const std::lock_guard lock(mutex_);
  return run_ ? run_->control.progress().fraction() : 0;
}

void BackgroundWork::carry_out(Run& run, const AnyWork& work) {
  StudyState ended = StudyState::done;
  std::string message;
  try {
    work(run.control, [&](std::shared_ptr<const void> found, const StudyStatus& status) {
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

}  // namespace ps::gui
