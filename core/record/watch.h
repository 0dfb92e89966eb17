#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "math/vec.h"

/// Values on the lines of a listing for one pixel. A listing says
///   PS_WATCH(name, value)      this value, on this line
///   PS_EACH(name, value)       what follows in this block is one instance of a loop (or call): sphere "red", light 2
///   PS_REACHING(name, value)   the same, forgotten at its end unless the pixel was reached inside
///   PS_PIXEL(x, y)             what follows in this block is work for pixel (x, y) of the canvas; it is kept for the
///                              pixel that is asked for alone, and reaches it
/// and a WatchCollector that is open on its thread keeps all that. Without one each costs a test of a pointer.

namespace ps {

using WatchValue = std::variant<bool, std::int64_t, double, Vec2d, Vec3d, std::string>;

/// "true", "3", "0.5", "(0, 1, 2)"
std::string watch_text(const WatchValue& value);

/// A value that a listing had on one of its lines.
struct Watch {
  int line = 0;
  std::string_view name;  ///< as the source spells it
  WatchValue value;
  int instance = -1;  ///< index of the innermost open WatchInstance; -1 = none
  bool operator==(const Watch&) const = default;
};

/// One time that a block of the listing was run through.
struct WatchInstance {
  int line = 0;
  std::string_view name;
  WatchValue value;
  int parent = -1;  ///< the instance around it; -1 = none
  bool operator==(const WatchInstance&) const = default;
};

/// Whether an instance is kept when the pixel was not reached inside it.
enum class WatchKeep { always, if_reached };

class WatchCollector;

namespace detail {
/// The innermost collector of this thread.
inline thread_local WatchCollector* watch_collector = nullptr;

template <class Value>
WatchValue watch_value(const Value& value) {
  if constexpr (std::is_integral_v<Value> && !std::is_same_v<Value, bool>)
    return static_cast<std::int64_t>(value);
  else if constexpr (std::is_floating_point_v<Value>)
    return static_cast<double>(value);
  else if constexpr (std::is_convertible_v<Value, std::string_view>)
    return std::string(std::string_view(value));
  else
    return value;
}
}  // namespace detail

/// Collects the watches of its thread while it lives. Collectors nest: the innermost one receives.
class WatchCollector {
 public:
  /// Watches beyond this number are counted, not kept; so are instances, with what is in them.
  static constexpr std::size_t limit = 10'000;

  /// `pixel` is the one that is asked for, as PS_PIXEL counts; without one PS_PIXEL listens to all.
  explicit WatchCollector(std::optional<Vec2i> pixel = {});
  /// Gets the watches of the work for one pixel, and all instances, which Watch::instance counts.
  using PixelSink =
      std::function<void(Vec2i pixel, std::span<const Watch> watches, const std::vector<WatchInstance>& instances)>;
  /// Hands over the work for every pixel at its end, and forgets it.
  explicit WatchCollector(PixelSink sink);
  ~WatchCollector();
  WatchCollector(const WatchCollector&) = delete;
  WatchCollector& operator=(const WatchCollector&) = delete;

  const std::vector<Watch>& watches() const { return watches_; }
  const std::vector<WatchInstance>& instances() const { return instances_; }
  std::size_t dropped() const { return dropped_; }

  void add(int line, std::string_view name, WatchValue value);
  void open(int line, std::string_view name, WatchValue value, WatchKeep keep);
  void close();
  /// Begins the work for one pixel: an instance that reaches it and all around it, or silence until close_pixel().
  void open_pixel(int line, int x, int y);
  void close_pixel();

  /// The innermost collector of this thread, or nullptr.
  static WatchCollector* current() { return detail::watch_collector; }

 private:
  struct Open {
    WatchKeep keep;
    bool reached;
    std::size_t watches;    // how many there were before it
    std::size_t instances;  // the same
    int instance;           // its index; -1 beyond the limit
  };
  int innermost() const { return open_.empty() ? -1 : open_.back().instance; }

  /// Ends the innermost instance; what is in it goes, unless it is to be kept.
  void close_keeping(bool all);

  WatchCollector* outer_;
  std::optional<Vec2i> pixel_;
  PixelSink sink_;
  std::vector<Watch> watches_;
  std::vector<WatchInstance> instances_;
  std::vector<Open> open_;
  std::size_t dropped_ = 0;
  int silent_ = 0;     // blocks of other pixels that are open
  int in_pixels_ = 0;  // blocks of pixels that are open
};

/// An instance for as long as it lives.
class WatchScope {
 public:
  template <class Value>
  WatchScope(int line, std::string_view name, const Value& value, WatchKeep keep)
      : collector_(WatchCollector::current()) {
    if (collector_) collector_->open(line, name, detail::watch_value(value), keep);
  }
  ~WatchScope() {
    if (collector_) collector_->close();
  }
  WatchScope(const WatchScope&) = delete;
  WatchScope& operator=(const WatchScope&) = delete;

 private:
  WatchCollector* collector_;
};

/// The work for one pixel for as long as it lives.
class WatchPixel {
 public:
  WatchPixel(int line, double x, double y) : collector_(WatchCollector::current()) {
    if (collector_) collector_->open_pixel(line, static_cast<int>(x), static_cast<int>(y));
  }
  ~WatchPixel() {
    if (collector_) collector_->close_pixel();
  }
  WatchPixel(const WatchPixel&) = delete;
  WatchPixel& operator=(const WatchPixel&) = delete;

 private:
  WatchCollector* collector_;
};

}  // namespace ps

#define PS_WATCH_JOIN2(a, b) a##b
#define PS_WATCH_JOIN(a, b) PS_WATCH_JOIN2(a, b)

#define PS_WATCH(name, value)                                                                                          \
  do {                                                                                                                 \
    if (::ps::WatchCollector* collector_ = ::ps::WatchCollector::current())                                            \
      collector_->add(__LINE__, name, ::ps::detail::watch_value(value));                                               \
  } while (false)
#define PS_EACH(name, value)                                                                                           \
  const ::ps::WatchScope PS_WATCH_JOIN(watch_scope_, __LINE__)(__LINE__, name, value, ::ps::WatchKeep::always)
#define PS_REACHING(name, value)                                                                                       \
  const ::ps::WatchScope PS_WATCH_JOIN(watch_scope_, __LINE__)(__LINE__, name, value, ::ps::WatchKeep::if_reached)
#define PS_PIXEL(x, y) const ::ps::WatchPixel PS_WATCH_JOIN(watch_pixel_, __LINE__)(__LINE__, x, y)
