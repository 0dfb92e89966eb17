#pragma once
#include <chrono>
#include <optional>
#include <string>
#include <utility>

namespace ps::gui {

/// The time by which a hand is quick or slow.
class HandClock {
 public:
  /// Seconds since some moment.
  double now() const {
    const std::chrono::duration<double> real = std::chrono::steady_clock::now().time_since_epoch();
    return stands_.value_or(real.count() + ahead_);
  }
  /// For scripts: so much more has passed.
  void pass(double seconds) { ahead_ += seconds; }
  /// For scripts: it stands at this time until the next call.
  void stand_at(double seconds) { stands_ = seconds; }

 private:
  double ahead_ = 0;
  std::optional<double> stands_;
};
/// The one of the window.
inline HandClock& hand_clock() {
  static HandClock clock;
  return clock;
}

/// The thing under the pointer, and since when. A click right after a change was meant for the one before.
class FreshPlace {
 public:
  /// Another text than before: something else is shown from here on.
  void shows(std::string what) {
    if (what == what_) return;
    what_ = std::move(what);
    since_ = hand_clock().now();
  }
  /// Whether it has been there for half a second, so that clicks count.
  bool settled() const { return hand_clock().now() - since_ >= 0.5; }

 private:
  std::string what_;
  double since_ = 0;
};

}  // namespace ps::gui
