#pragma once
#include <utility>
#include <vector>

#include "base/counters.h"
#include "record/events.h"

namespace ps {

/// Kernels are templates over a Recorder. All three have the same members:
///   count(c, n)      adds to a counter
///   at(x, y)         what follows belongs to that pixel
///   wants(x, y)      whether events of pixel (x, y) are collected
///   event(make)      collects make() (an event struct), a leaf of the tree
///   begin(make)      collects make() and makes it the parent of what follows, until end()
///   end(), end(make) the latter puts make() in the place of what begin() collected
///   collects()       whether events are kept at the moment
/// The constants say whether it counts, whether it keeps events, and whether all that is drawn is one pixel.
/// `make` is a callable, evaluated only where its result is kept, so that building an event has no cost elsewhere.

/// Collects no event and compiles to no code.
struct Silent {
  static constexpr bool counts = false;
  static constexpr bool records = false;
  static constexpr bool one_pixel = false;
  void count(Counter, std::uint64_t = 1) {}
  void at(int, int) {}
  static constexpr bool wants(int, int) { return false; }
  template <class Make>
  void event(Make&&) {}
  template <class Make>
  void begin(Make&&) {}
  void end() {}
  template <class Make>
  void end(Make&&) {}
  static constexpr bool collects() { return false; }
};

/// Counts work, and is silent about the rest. One per tile, added up in tile order.
struct CountingRecorder : Silent {
  static constexpr bool counts = true;
  Counters counters;
  void count(Counter c, std::uint64_t n = 1) { counters[c] += n; }
};

/// Counts, and collects the events of one pixel.
class PixelRecorder {
 public:
  static constexpr bool counts = true;
  static constexpr bool records = true;
  static constexpr bool one_pixel = true;
  explicit PixelRecorder(Vec2i pixel) : pixel_(pixel) {}

  Counters counters;
  void count(Counter c, std::uint64_t n = 1) { counters[c] += n; }
  void at(int, int) {}
  bool wants(int x, int y) const { return x == pixel_.x && y == pixel_.y; }
  Vec2i pixel() const { return pixel_; }
  /// Muted, it only counts: for work that must be repeated before the pixel's own begins.
  void mute(bool muted) { muted_ = muted; }
  bool collects() const { return !muted_; }
  template <class Make>
  void event(Make&& make) {
    if (muted_) return;
    events_.push_back({parent(), EventData(std::forward<Make>(make)())});
  }
  template <class Make>
  void begin(Make&& make) {
    if (muted_) return;
    event(std::forward<Make>(make));
    open_.push_back(static_cast<int>(events_.size()) - 1);
  }
  void end() {
    if (!muted_) open_.pop_back();
  }
  template <class Make>
  void end(Make&& make) {
    if (muted_) return;
    events_[static_cast<std::size_t>(open_.back())].data = EventData(std::forward<Make>(make)());
    open_.pop_back();
  }
  std::vector<Event> take() { return std::move(events_); }

 private:
  int parent() const { return open_.empty() ? -1 : open_.back(); }
  Vec2i pixel_;
  std::vector<Event> events_;
  std::vector<int> open_;
  bool muted_ = false;
};

}  // namespace ps
