#pragma once
#include <cstdint>
#include <limits>
#include <optional>
#include <type_traits>

#include "record/recorder.h"

namespace ps::raster {

/// Thrown by SteppingRecorder out of a kernel. Nothing is wrong: the kernel has gone as far as it was to go.
struct StepReached {};

/// A recorder (record/recorder.h) that lets a kernel go on until it begins with fragment number `limit` + 1, and keeps
/// what the last fragment before was.
class SteppingRecorder : public CountingRecorder {
 public:
  explicit SteppingRecorder(std::uint64_t limit) : limit_(limit) {}

  void count(Counter c, std::uint64_t n = 1) {
    if (c == Counter::fragments) {
      if (fragments_ == limit_) throw StepReached();
      ++fragments_;
    }
    CountingRecorder::count(c, n);
  }
  template <class Make>
  void event(Make&& make) {
    if constexpr (std::is_same_v<std::decay_t<decltype(make())>, FragmentEvent>)
      if (fragments_ == limit_) last_ = make();
  }
  template <class Make>
  void begin(Make&& make) {
    event(std::forward<Make>(make));
  }

  /// Fragment number `limit`, if the kernel has reported it; one that an opacity map cuts out is not reported.
  const std::optional<FragmentEvent>& last() const { return last_; }

 private:
  std::uint64_t limit_, fragments_ = 0;
  std::optional<FragmentEvent> last_;
};

}  // namespace ps::raster
