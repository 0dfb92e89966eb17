#pragma once
#include <algorithm>
#include <atomic>
#include <cstdint>
#include <exception>

namespace ps {

/// Thrown out of a long call when its Progress was asked to stop. It is not a fault; the result is incomplete.
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
  /// From here on the work comes in this number of parts of about the same length, which announce their units one after
  /// another: the first begins at once, each of the others with next_part().
  void expect_parts(int parts) noexcept {
    parts_.store(parts, std::memory_order_relaxed);
    part_.store(0, std::memory_order_relaxed);
    forget_units();
  }
  void next_part() noexcept {
    part_.fetch_add(1, std::memory_order_relaxed);
    forget_units();
  }
  /// Share of the announced work that is done, in [0, 1]; 0 while none is announced.
  double fraction() const noexcept {
    const double parts = parts_.load(std::memory_order_relaxed), before = part_.load(std::memory_order_relaxed);
    return std::min(1.0, (before + fraction_of_part()) / parts);
  }

 private:
  void forget_units() noexcept {
    total_.store(0, std::memory_order_relaxed);
    done_.store(0, std::memory_order_relaxed);
  }
  double fraction_of_part() const noexcept {
    const auto total = total_.load(std::memory_order_relaxed);
    const auto done = done_.load(std::memory_order_relaxed);
    if (total <= 0) return 0.0;
    return done >= total ? 1.0 : static_cast<double>(done) / static_cast<double>(total);
  }

  std::atomic<bool> stop_{false};
  std::atomic<std::int64_t> total_{0};
  std::atomic<std::int64_t> done_{0};
  std::atomic<int> parts_{1}, part_{0};
};

}  // namespace ps
