#pragma once
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "gui/work/newest_job.h"
#include "study/control.h"

namespace ps::gui {

enum class StudyState { none, running, paused, done, cancelled, failed };

/// One long piece of work at a time in the background. All members are for the window's thread and return at once; the
/// destructor stops the work and waits until it has ended. A BackgroundStudy adds what is found.
class BackgroundWork {
 public:
  /// `wake` is called from another thread when there is something new; it must not block.
  explicit BackgroundWork(std::function<void()> wake) : wake_(std::move(wake)) {}
  ~BackgroundWork() { cancel(); }
  BackgroundWork(const BackgroundWork&) = delete;
  BackgroundWork& operator=(const BackgroundWork&) = delete;

  void cancel();
  /// Waits between two of its runs until it is resumed.
  void set_paused(bool paused);
  /// The same without being shown as paused: the views render, and neither shall disturb the other.
  void set_held(bool held);

  StudyState state() const;
  /// Running or paused.
  bool running() const;
  StudyStatus status() const;
  /// Why it failed.
  std::string message() const;
  /// Share of what is being rendered now, in [0, 1].
  double fraction_of_render() const;

 protected:
  using PublishAny = std::function<void(std::shared_ptr<const void>, const StudyStatus&)>;
  using AnyWork = std::function<void(StudyControl&, const PublishAny&)>;
  void start_any(AnyWork work);
  std::shared_ptr<const void> found_any() const;

 private:
  struct Run {
    StudyControl control;
    bool paused = false, held = false;  // of the window's thread
    StudyState state = StudyState::running;
    std::shared_ptr<const void> found;
    StudyStatus status;
    std::string message;
  };
  void carry_out(Run& run, const AnyWork& work);

  const std::function<void()> wake_;
  mutable std::mutex mutex_;  // guards state, found, status and message of the run, and which run it is
  std::shared_ptr<Run> run_;

  NewestJob job_;  // last, so that its thread ends before what it uses
};

/// One long study at a time in the background, and the newest of what it has found.
template <class Found>
class BackgroundStudy : public BackgroundWork {
 public:
  /// Called by the study whenever there is more to see. What is handed over is never changed again.
  using Publish = std::function<void(std::shared_ptr<const Found>, const StudyStatus&)>;
  /// May throw Cancelled, and InputError, whose text becomes message().
  using Work = std::function<void(StudyControl&, const Publish&)>;

  using BackgroundWork::BackgroundWork;

  /// Stops the study that runs and begins this one.
  void start(Work work) {
    start_any([work = std::move(work)](StudyControl& control, const PublishAny& publish) { work(control, publish); });
  }
  /// The newest of the study that was started last; nullptr before it has anything.
  std::shared_ptr<const Found> found() const { return std::static_pointer_cast<const Found>(found_any()); }
};

}  // namespace ps::gui
