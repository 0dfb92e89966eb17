#include "inspect/watch.h"

namespace ps {
namespace {

thread_local WatchCollector* innermost = nullptr;

}  // namespace

WatchCollector::WatchCollector() : outer_(innermost) { innermost = this; }

WatchCollector::~WatchCollector() { innermost = outer_; }

void WatchCollector::rewind(std::size_t count) {
  if (count < watches_.size()) watches_.resize(count);
}

void WatchCollector::add(Watch watch) {
  if (watches_.size() < limit)
    watches_.push_back(std::move(watch));
  else
    ++dropped_;
}

WatchCollector* WatchCollector::current() { return innermost; }

WatchScope::WatchScope() : collector_(WatchCollector::current()) {
  if (collector_) start_ = collector_->watches().size();
}

WatchScope::~WatchScope() {
  if (collector_ && !keep_) collector_->rewind(start_);
}

}  // namespace ps
