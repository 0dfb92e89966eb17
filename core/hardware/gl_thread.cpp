#include "hardware/gl_thread.h"

#include "base/check.h"
#include "base/task_thread.h"

namespace ps::hardware {
namespace {

/// The thread with its context. It lives as long as the program: a driver's own threads and its exit handlers end in an
/// order that nobody else knows.
class GlThread {
 public:
  GlThread() {
    thread_.run([&] {
      try {
        context_ = std::make_unique<Context>(Api::desktop);
        workshop_ = std::make_unique<Workshop>(*context_);
        available_.driver = context_->driver();
      } catch (const InputError& error) {
        available_.reason = error.what();
      }
    });
  }
  static GlThread& get() {
    static GlThread& thread = *new GlThread;  // never deleted, see above
    return thread;
  }

  const Availability& available() const { return available_; }
  void run(const std::function<void(Workshop&)>& task) {
    if (!available_.driver) throw InputError(available_.reason);
    thread_.run([&] {
      context_->make_current();  // a task may have made another context current
      forget_errors();           // of a task that has ended early
      task(*workshop_);
    });
  }

 private:
  Availability available_;
  std::unique_ptr<Context> context_;
  std::unique_ptr<Workshop> workshop_;
  TaskThread thread_;
};

}  // namespace

const Availability& availability() { return GlThread::get().available(); }

void on_gl_thread(const std::function<void(Workshop&)>& task) { GlThread::get().run(task); }

}  // namespace ps::hardware
