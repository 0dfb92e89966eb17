#include "base/parallel.h"

#include <sys/resource.h>
#include <unistd.h>

#include <atomic>
#include <fstream>
#include <mutex>
#include <set>
#include <stdexcept>
#include <system_error>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "image/image.h"
#include "support/emulated.h"
#include "support/trials.h"

namespace ps::parallel_test {
namespace {

TEST(Parallel, RunsEveryIndexOnceOnAnyNumberOfThreads) {
  for (const int threads : {1, 2, 7}) {
    std::vector<std::atomic<int>> runs(1000);
    Progress progress;
    parallel_for(1000, {.threads = threads}, progress, [&](int index, int worker) {
      EXPECT_GE(worker, 0);
      EXPECT_LT(worker, threads);
      runs[static_cast<std::size_t>(index)].fetch_add(1);
    });
    for (const auto& count : runs) EXPECT_EQ(count.load(), 1);
    EXPECT_EQ(progress.fraction(), 1.0);
  }
}

/// The threads that a call worked on; each of them took part.
std::set<std::thread::id> threads_of_call(int threads) {
  std::atomic<int> arrived{0};
  std::mutex mutex;
  std::set<std::thread::id> ids;
  Progress progress;
  parallel_for(threads, {.threads = threads}, progress, [&](int, int) {
    arrived.fetch_add(1);
    while (arrived.load() < threads) std::this_thread::yield();
    const std::lock_guard lock(mutex);
    ids.insert(std::this_thread::get_id());
  });
  return ids;
}

TEST(Parallel, StartsAsManyThreadsAsAsked) {
  for (const int threads : {1, 2, 7}) {
    EXPECT_EQ(threads_of_call(threads).size(), static_cast<std::size_t>(threads));
  }
}

TEST(Parallel, KeepsItsThreads) {
  const auto first = threads_of_call(2);
  for (int i = 0; i < 10; ++i) EXPECT_EQ(threads_of_call(2), first);
}

/// Takes away the memory that the stacks of further threads would need, until the end of the scope.
class NoMoreThreads {
 public:
  NoMoreThreads() {
    getrlimit(RLIMIT_AS, &before_);
    rlimit little = before_;
    std::size_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    constexpr std::size_t room = 24u << 20;  // for two or three stacks
    little.rlim_cur = pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE)) + room;
    setrlimit(RLIMIT_AS, &little);
  }
  ~NoMoreThreads() { setrlimit(RLIMIT_AS, &before_); }
  NoMoreThreads(const NoMoreThreads&) = delete;
  NoMoreThreads& operator=(const NoMoreThreads&) = delete;

 private:
  rlimit before_{};
};

/// How many threads can be had at a time, `most` at most.
int threads_that_start(int most) {
  std::atomic<bool> ended{false};
  std::vector<std::thread> threads;
  try {
    while (static_cast<int>(threads.size()) < most)
      threads.emplace_back([&] {
        while (!ended.load()) std::this_thread::yield();
      });
  } catch (const std::system_error&) {  // no more
  }
  ended.store(true);
  for (std::thread& thread : threads) thread.join();
  return static_cast<int>(threads.size());
}

TEST(Parallel, WorksWithTheThreadsThatThereAre) {
  if (test::trial_divisor > 1 || test::is_emulated()) GTEST_SKIP() << "the tool needs the memory itself";
  for (const WorkerPriority priority : {WorkerPriority::normal, WorkerPriority::background}) {
    const NoMoreThreads limit;
    ASSERT_LT(threads_that_start(64), 64) << "the limit acts";
    std::atomic<int> runs{0};
    Progress progress;
    parallel_for(1000, {.threads = 64, .priority = priority}, progress, [&](int, int worker) {
      EXPECT_LT(worker, 64);
      runs.fetch_add(1);
    });
    EXPECT_EQ(runs.load(), 1000);
  }
}

TEST(Parallel, RunsInsideItselfAndBesideItself) {
  std::atomic<int> runs{0};
  const auto call = [&] {
    Progress progress;
    parallel_for(3, {.threads = 3}, progress, [&](int, int) {
      Progress inner;
      parallel_for(50, {.threads = 2}, inner, [&](int, int) { runs.fetch_add(1); });
    });
  };
  std::thread beside([&] {
    for (int i = 0; i < 20; ++i) call();
  });
  for (int i = 0; i < 20; ++i) call();
  beside.join();
  EXPECT_EQ(runs.load(), 2 * 20 * 3 * 50);
}

TEST(Parallel, CarriesTheFirstExceptionOut) {
  Progress progress;
  std::atomic<int> runs{0};
  const auto body = [&](int index, int) {
    runs.fetch_add(1);
    if (index == 3) throw std::runtime_error("index 3");
  };
  EXPECT_THROW(parallel_for(1'000'000, {.threads = 2}, progress, body), std::runtime_error);
  EXPECT_LT(runs.load(), 1'000'000);
}

TEST(Parallel, StopsWhenAsked) {
  Progress progress;
  std::atomic<int> runs{0};
  const auto body = [&](int, int) {
    if (runs.fetch_add(1) == 10) progress.request_stop();
  };
  EXPECT_THROW(parallel_for(1'000'000, {.threads = 2}, progress, body), Cancelled);
  EXPECT_LT(runs.load(), 1'000'000);
  EXPECT_LT(progress.fraction(), 1.0);
}

TEST(Parallel, DoesNothingForNoWork) {
  Progress progress;
  parallel_for(0, {}, progress, [](int, int) { FAIL() << "nothing to run"; });
}

TEST(Tiles, CoverEachPixelOnce) {
  for (const auto& [width, height, size] : {std::array{1, 1, 32}, {33, 65, 32}, {600, 600, 64}, {7, 100, 1}}) {
    Image<int> hits(width, height);
    for (const TileRect& tile : make_tiles(width, height, size)) {
      EXPECT_LE(tile.width(), size);
      EXPECT_LE(tile.height(), size);
      for (int y = tile.y0; y < tile.y1; ++y)
        for (int x = tile.x0; x < tile.x1; ++x) ++hits.at(x, y);
    }
    for (const int count : hits.pixels()) EXPECT_EQ(count, 1);
  }
}

}  // namespace
}  // namespace ps::parallel_test
