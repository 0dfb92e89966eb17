#pragma once
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>

#include "base/check.h"
#include "gui/work/newest_job.h"

namespace ps::gui {

/// Makes results of requests in the background. While one is being made the next request is only noted, so that results
/// keep coming during a drag. All members are for the window's thread and return at once.
template <class Request, class Result>
class LatestResult {
 public:
  using Make = std::function<Result(const Request&, Progress&)>;
  using Same = std::function<bool(const Request&, const Request&)>;

  /// `make` runs on the background thread; an InputError from it leaves the last result. `wake` is called from that
  /// thread when a result has come. With `stops`, the one that is being made is given up where stops(it, request)
  /// holds.
  LatestResult(Make make, Same same, std::function<void()> wake, Same stops = {})
      : make_(std::move(make)), same_(std::move(same)), wake_(std::move(wake)), stops_(std::move(stops)) {}

  /// Asks for a result unless it is the newest one already; called in every frame.
  void request(const Request& request) {
    wanted_ = request;
    const std::lock_guard lock(mutex_);
    if (running_ && stops_ && stops_(*started_, *wanted_)) job_.cancel();
    if (running_ || (started_ && same_(*started_, *wanted_))) return;
    running_ = true;
    started_ = wanted_;
    job_.start([this, started = *started_](Progress& progress) {
      std::shared_ptr<const Result> made;
      try {
        made = std::make_shared<const Result>(make_(started, progress));
      } catch (const InputError&) {
        // What cannot be made leaves the last one on the screen.
      } catch (const Cancelled&) {
        // Another one is wanted instead.
      }
      {
        const std::lock_guard inner(mutex_);
        if (made) result_ = std::move(made);
        running_ = false;
        news_ = true;
      }
      if (wake_) wake_();
    });
  }
  /// Nothing is wanted any more.
  void rest() { wanted_.reset(); }
  /// The newest result; nullptr if there is none.
  std::shared_ptr<const Result> result() const {
    const std::lock_guard lock(mutex_);
    return result_;
  }
  /// The result of the newest request is still to come.
  bool busy() const {
    const std::lock_guard lock(mutex_);
    return running_ || (wanted_ && !(started_ && same_(*started_, *wanted_)));
  }
  /// A result has come since take_news().
  bool has_news() const {
    const std::lock_guard lock(mutex_);
    return news_;
  }
  void take_news() {
    const std::lock_guard lock(mutex_);
    news_ = false;
  }

 private:
  const Make make_;
  const Same same_;
  const std::function<void()> wake_;
  const Same stops_;
  std::optional<Request> wanted_, started_;
  mutable std::mutex mutex_;  // guards all down to news_
  std::shared_ptr<const Result> result_;
  bool running_ = false, news_ = false;

  NewestJob job_;  // last, so that its thread ends before what it uses
};

}  // namespace ps::gui
