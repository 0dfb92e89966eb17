#pragma once
#include <atomic>
#include <cstdint>
#include <exception>

namespace ps {

/// Thrown out of a long call when its Progress was asked to stop. Nothing is wrong; the result is incomplete.
class Cancelled : public std::exception {
 public:
  const char* what() const noexcept override { return "cancelled"; }
};

/// Shared by the caller of a long operation and the workers that carry it out. All members may be called from any
/// thread.
class Progress {
 public:
  /// Asks the operation to end soon. It then throws Cancelled.
  void request_stop() noexcept { stop_.store(true, std::memory_order_relaxed); }
  bool stop_requested() const noexcept { return stop_.load(std::memory_order_relaxed); }
  /// Throws Cancelled if a stop was requested; called between tiles, rows or batches.
  void check() const {
    if (stop_requested()) throw Cancelled();
  }

  /// Announces `units` more units of work, in whatever unit the operation counts.
  void expect(std::int64_t units) noexcept { total_.fetch_add(units, std::memory_order_relaxed); }
  void advance(std::int64_t units = 1) noexcept { done_.fetch_add(units, std::memory_order_relaxed); }
  /// Share of the announced work that is done, in [0, 1]; 0 while nothing is announced.
  double fraction() const noexcept {
    const auto total = total_.load(std::memory_order_relaxed);
    const auto done = done_.load(std::memory_order_relaxed);
    if (total <= 0) return 0.0;
    return done >= total ? 1.0 : static_cast<double>(done) / static_cast<double>(total);
  }

 private:
  std::atomic<bool> stop_{false};
  std::atomic<std::int64_t> total_{0};
  std::atomic<std::int64_t> done_{0};
};

}  // namespace ps
