#pragma once
#include <string>
#include <type_traits>
#include <vector>

#include "inspect/number_text.h"

/// PS_WATCH(name, value) in a listing records the line it stands on and the value, for the collector that is open on
/// this thread. Without one it costs a test of a pointer.

namespace ps {

/// A value that a listing had on one of its lines.
struct Watch {
  int line = 0;
  std::string name;
  std::string value;
  bool operator==(const Watch&) const = default;
};

/// Collects the watches of its thread while it lives. Collectors nest: the innermost one receives.
class WatchCollector {
 public:
  /// Watches beyond this number are counted, not kept.
  static constexpr std::size_t limit = 10'000;

  WatchCollector();
  ~WatchCollector();
  WatchCollector(const WatchCollector&) = delete;
  WatchCollector& operator=(const WatchCollector&) = delete;

  const std::vector<Watch>& watches() const { return watches_; }
  std::size_t dropped() const { return dropped_; }
  /// Forgets what came after the first `count` watches: for a scope that turned out not to reach the pixel.
  void rewind(std::size_t count);
  void add(Watch watch);

  /// The innermost collector of this thread, or nullptr.
  static WatchCollector* current();

 private:
  WatchCollector* outer_;
  std::vector<Watch> watches_;
  std::size_t dropped_ = 0;
};

/// Watches inside such a scope are dropped again at its end unless keep() was called: a listing keeps those of the
/// triangle, row or pixel that reached the clicked pixel.
class WatchScope {
 public:
  WatchScope();
  ~WatchScope();
  WatchScope(const WatchScope&) = delete;
  WatchScope& operator=(const WatchScope&) = delete;
  void keep() { keep_ = true; }

 private:
  WatchCollector* collector_;
  std::size_t start_ = 0;
  bool keep_ = false;
};

namespace detail {
inline std::string watch_text(bool value) { return value ? "true" : "false"; }
inline std::string watch_text(const Vec2d& value) { return vector_text(value); }
inline std::string watch_text(const Vec3d& value) { return vector_text(value); }
inline std::string watch_text(const std::string& value) { return value; }
template <class Number>
requires(std::is_arithmetic_v<Number>) std::string watch_text(Number value) {
  if constexpr (std::is_integral_v<Number>)
    return std::to_string(value);
  else
    return number_text(static_cast<double>(value));
}
}  // namespace detail

}  // namespace ps

#define PS_WATCH(name, value)                                                                                          \
  do {                                                                                                                 \
    if (::ps::WatchCollector* collector_ = ::ps::WatchCollector::current())                                            \
      collector_->add({__LINE__, name, ::ps::detail::watch_text(value)});                                              \
  } while (false)
