#include "base/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <map>
#include <memory>
#include <mutex>
#include <system_error>
#include <thread>

#ifdef __linux__
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>
#endif

#include "base/check.h"
#include "base/stop.h"

namespace ps {
namespace {

/// Lets the window's own thread run first. Linux gives each thread its own nice value, which the threads that it starts
/// inherit.
constexpr int background_nice = 10;

void set_own_nice([[maybe_unused]] int nice) {
#ifdef __linux__
  setpriority(PRIO_PROCESS, static_cast<id_t>(syscall(SYS_gettid)), nice);
#endif
}
int own_nice() {
#ifdef __linux__
  return getpriority(PRIO_PROCESS, static_cast<id_t>(syscall(SYS_gettid)));
#else
  return 0;
#endif
}

/// A thread that is kept when its work is done: a frame is drawn in several steps, and to start a thread for each takes
/// as long as drawing a simple picture.
class Helper {
 public:
  explicit Helper(int nice)
      : thread_([this, nice] {
          if (nice != own_nice()) set_own_nice(nice);
          while (wait_while(State::idle) != State::ending) {
            if (!move(State::asked, State::working)) continue;  // it was taken back
            (*work_)(worker_);
            change(State::idle);
          }
        }) {}
  ~Helper() {
    change(State::ending);
    thread_.join();
  }
  Helper(const Helper&) = delete;
  Helper& operator=(const Helper&) = delete;

  /// Calls work(worker) on the thread; `work` must not throw, and must stay until finish() has returned.
  void start(const std::function<void(int)>& work, int worker) {
    work_ = &work;
    worker_ = worker;
    change(State::asked);
  }
  /// Waits until that call has returned.
  void finish() {
    wait_while(State::asked);
    wait_while(State::working);
  }
  /// The same where nothing is left to do: if the thread has not begun the call, it is taken back. On a busy machine it
  /// may take longer to wake up than all of the work.
  void finish_early() {
    if (!move(State::asked, State::idle)) wait_while(State::working);
  }

 private:
  enum class State : int { idle, asked, working, ending };

  /// Sequentially consistent, since notify_all() wakes none if none seems to wait: with a weaker order the processor
  /// may look for them before others see the new state, and who begins to wait just then would wait for ever.
  void change(State to) {
    state_.store(to, std::memory_order_seq_cst);
    state_.notify_all();
  }
  /// False if the state is not `from`.
  bool move(State from, State to) { return state_.compare_exchange_strong(from, to, std::memory_order_acq_rel); }
  /// The state after `now`. Looks for it a few microseconds long, which is shorter than to fall asleep and wake up.
  State wait_while(State now) const {
    constexpr int tries = 64;
    for (int i = 0; i < tries; ++i) {
      if (const State state = state_.load(std::memory_order_acquire); state != now) return state;
      std::this_thread::yield();
    }
    state_.wait(now, std::memory_order_acquire);
    return state_.load(std::memory_order_acquire);
  }

  const std::function<void(int)>* work_ = nullptr;
  int worker_ = 0;
  std::atomic<State> state_{State::idle};
  std::thread thread_;  ///< the last member, for it uses the others from its beginning
};

using Helpers = std::vector<std::unique_ptr<Helper>>;

/// Helpers without work, by their nice value. No more of each are kept than the machine can run at once.
class IdleHelpers {
 public:
  /// Fewer than asked for where the system has no more threads to give.
  Helpers take(std::size_t count, int nice) {
    Helpers taken;
    taken.reserve(count);
    {
      const std::lock_guard lock(mutex_);
      Helpers& idle = idle_[nice];
      while (taken.size() < count && !idle.empty()) {
        taken.push_back(std::move(idle.back()));
        idle.pop_back();
      }
    }
    try {
      while (taken.size() < count) taken.push_back(std::make_unique<Helper>(nice));
    } catch (const std::system_error&) {
      return taken;
    }
    return taken;
  }
  void give_back(Helpers& helpers, int nice) {
    const auto most = static_cast<std::size_t>(resolve_threads({}));
    const std::lock_guard lock(mutex_);
    Helpers& idle = idle_[nice];
    while (!helpers.empty() && idle.size() < most) {
      idle.push_back(std::move(helpers.back()));
      helpers.pop_back();
    }
  }
  static IdleHelpers& all() {
    static IdleHelpers helpers;
    return helpers;
  }

 private:
  std::mutex mutex_;
  std::map<int, Helpers> idle_;
};

}  // namespace

std::vector<TileRect> make_tiles(int width, int height, int size) {
  PS_ASSERT(size > 0, "tiles need a size");
  std::vector<TileRect> tiles;
  for (int y = 0; y < height; y += size)
    for (int x = 0; x < width; x += size)
      tiles.push_back({x, y, std::min(x + size, width), std::min(y + size, height)});
  return tiles;
}

int resolve_threads(const ParallelOptions& options) {
  if (options.threads > 0) return options.threads;
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

void parallel_for(int count, const ParallelOptions& options, Progress& progress,
                  const std::function<void(int index, int worker)>& body) {
  if (count <= 0) return;
  progress.expect(count);
  std::atomic<int> next{0};
  std::atomic<bool> failed{false};
  std::exception_ptr failure;
  std::mutex failure_mutex;

  const Progress* const caller_stop = current_stop();
  const std::function<void(int)> work = [&](int worker) {
    const StopScope scope(caller_stop);
    try {
      while (!failed.load(std::memory_order_relaxed)) {
        progress.check();
        check_stop();
        const int index = next.fetch_add(1, std::memory_order_relaxed);
        if (index >= count) break;
        body(index, worker);
        progress.advance();
      }
    } catch (...) {
      const std::lock_guard lock(failure_mutex);
      if (!failure) failure = std::current_exception();
      failed.store(true, std::memory_order_relaxed);
    }
  };

  const int threads = std::min(resolve_threads(options), count);
  // The caller is one of the workers, unless they have a priority of their own, which it could not take back.
  const bool own_priority = options.priority == WorkerPriority::normal;
  const int first = own_priority ? 1 : 0;
  const int nice = own_priority ? own_nice() : background_nice;
  Helpers helpers = IdleHelpers::all().take(static_cast<std::size_t>(threads - first), nice);
  for (std::size_t i = 0; i < helpers.size(); ++i) helpers[i]->start(work, static_cast<int>(i) + first);
  if (own_priority || helpers.empty()) work(0);
  if (!own_priority && !helpers.empty()) helpers[0]->finish();  // then all indices are taken
  for (const auto& helper : helpers) helper->finish_early();
  IdleHelpers::all().give_back(helpers, nice);
  if (failure) std::rethrow_exception(failure);
}

}  // namespace ps
