#include "record/watch.h"

namespace ps {

WatchCollector::WatchCollector(std::optional<Vec2i> pixel) : outer_(detail::watch_collector), pixel_(pixel) {
  detail::watch_collector = this;
}

WatchCollector::WatchCollector(PixelSink sink) : WatchCollector() { sink_ = std::move(sink); }

WatchCollector::~WatchCollector() { detail::watch_collector = outer_; }

void WatchCollector::add(int line, std::string_view name, WatchValue value) {
  if (silent_ > 0 || (sink_ && in_pixels_ == 0)) return;
  if (watches_.size() < limit && (open_.empty() || open_.back().instance >= 0))
    watches_.push_back({line, name, std::move(value), innermost()});
  else
    ++dropped_;
}

void WatchCollector::open(int line, std::string_view name, WatchValue value, WatchKeep keep) {
  if (silent_ > 0) return;
  const bool kept = instances_.size() < limit && (open_.empty() || open_.back().instance >= 0);
  const int index = kept ? static_cast<int>(instances_.size()) : -1;
  open_.push_back({keep, false, watches_.size(), instances_.size(), index});
  if (!kept) return;
  const int parent = open_.size() > 1 ? open_[open_.size() - 2].instance : -1;
  instances_.push_back({line, name, std::move(value), parent});
}

void WatchCollector::close() {
  if (silent_ > 0) return;
  const Open& last = open_.back();
  close_keeping(sink_ ? in_pixels_ > 0 : last.keep == WatchKeep::always || last.reached);
}

void WatchCollector::close_keeping(bool all) {
  const Open last = open_.back();
  open_.pop_back();
  if (all) return;
  if (last.watches < watches_.size()) watches_.resize(last.watches);
  if (last.instances < instances_.size()) instances_.resize(last.instances);
}

void WatchCollector::open_pixel(int line, int x, int y) {
  if (silent_ > 0 || (pixel_ && (pixel_->x != x || pixel_->y != y))) {
    ++silent_;
    return;
  }
  open(line, "pixel", Vec2d(x, y), WatchKeep::always);
  for (Open& open : open_) open.reached = true;
  ++in_pixels_;
}

void WatchCollector::close_pixel() {
  if (silent_ > 0) {
    --silent_;
    return;
  }
  --in_pixels_;
  if (!sink_) return close();
  const Open& work = open_.back();
  if (work.instance >= 0) {
    const auto place = std::get<Vec2d>(instances_[static_cast<std::size_t>(work.instance)].value);
    sink_({static_cast<int>(place.x), static_cast<int>(place.y)},
          std::span<const Watch>(watches_).subspan(work.watches), instances_);
  }
  close_keeping(false);
}

}  // namespace ps
