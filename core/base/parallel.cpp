#include "base/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>

#ifdef __linux__
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>
#endif

#include "base/check.h"

namespace ps {
namespace {

/// Lets the window's own thread run first. Linux gives each thread its own nice value.
void lower_own_priority() {
#ifdef __linux__
  constexpr int background_nice = 10;
  setpriority(PRIO_PROCESS, static_cast<id_t>(syscall(SYS_gettid)), background_nice);
#endif
}

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

  const auto work = [&](int worker) {
    if (options.priority == WorkerPriority::background) lower_own_priority();
    try {
      while (!failed.load(std::memory_order_relaxed)) {
        progress.check();
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
  const bool caller_works = options.priority == WorkerPriority::normal;
  std::vector<std::thread> pool;
  pool.reserve(static_cast<std::size_t>(threads));
  for (int worker = caller_works ? 1 : 0; worker < threads; ++worker) pool.emplace_back(work, worker);
  if (caller_works) work(0);
  for (auto& thread : pool) thread.join();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace ps
