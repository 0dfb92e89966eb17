#include "hardware/gl_thread.h"

#include <atomic>
#include <utility>
#include <vector>

#include "base/check.h"
#include "base/return_free_memory.h"
#include "base/task_thread.h"

namespace ps::hardware {
namespace {

/// The thread with its context. It lives as long as the program: a driver's own threads and its exit handlers end in an
/// order that only the driver knows.
class GlThread {
 public:
  GlThread() {
    thread_.run([&] { open(); });
    started_ = true;
  }
  static bool started() { return started_; }
  static GlThread& get() {
    static GlThread& thread = *new GlThread;  // never deleted, see above
    return thread;
  }

  const Availability& available() const { return available_; }
  void run(const std::function<void(Workshop&)>& task) {
    if (!available_.driver) throw InputError(available_.reason);
    thread_.run([&] {
      if (!workshop_) open();
      if (!workshop_) throw InputError(reopening_);
      try {
        workshop_->context.make_current();  // a task may have made another context current
        forget_errors();                    // of a task that has ended early
        task(*workshop_);
      } catch (const ContextLost&) {
        lost_.push_back({std::move(context_), std::move(workshop_)});
        throw;
      }
    });
  }

 private:
  static inline std::atomic<bool> started_{false};
  struct Lost {
    std::unique_ptr<Context> context;
    std::unique_ptr<Workshop> workshop;
  };

  void open() {
    try {
      context_ = std::make_unique<Context>(Api::desktop);
      workshop_ = std::make_unique<Workshop>(*context_);
      if (!available_.driver) available_.driver = context_->driver();
    } catch (const InputError& error) {
      (available_.driver ? reopening_ : available_.reason) = error.what();
    }
  }

  Availability available_;  ///< as it was at the start: read by other threads
  std::string reopening_;   ///< why there is no context after one was lost
  std::unique_ptr<Context> context_;
  std::unique_ptr<Workshop> workshop_;
  std::vector<Lost> lost_;  ///< not deleted: what they held is gone, and the calls would reach the next context
  TaskThread thread_;
};

}  // namespace

void Workshop::tidy() {
  meshes.tidy();
  textures.tidy();
  const std::size_t before = programs.size();
  while (programs.size() > most_programs) {
    const auto oldest = least_recent(programs);
    if (oldest->second.used > last_picture) break;
    programs.erase(oldest);
  }
  last_picture = clock;
  // A driver that compiles for the processor leaves its heap in pieces.
  if (programs.size() < before) return_free_memory();
}

const Availability& availability() { return GlThread::get().available(); }

bool driver_is_known() { return GlThread::started(); }

void on_gl_thread(const std::function<void(Workshop&)>& task) { GlThread::get().run(task); }

}  // namespace ps::hardware
