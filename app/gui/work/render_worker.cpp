#include "gui/work/render_worker.h"

#include <algorithm>
#include <utility>

#include "base/failure_text.h"
#include "base/timer.h"
#include "frame/display_frame.h"
#include "options/option.h"

namespace ps::gui {
namespace {

/// A picture that was there within this time needs no coarse one before it.
constexpr double quick_milliseconds = 30;
constexpr int largest_coarse_divisor = 8;

/// Pixels of a new picture that no tile has reached yet.
constexpr Rgb8 not_yet_there{96, 96, 96};

TileRect whole(int width, int height) { return {0, 0, width, height}; }

/// Where pixels of a coarse picture lie in the full one.
TileRect enlarged(const TileRect& rect, int divisor, const View& full) {
  return {rect.x0 * divisor, rect.y0 * divisor, std::min(rect.x1 * divisor, full.width),
          std::min(rect.y1 * divisor, full.height)};
}

/// Copies `rect` of a picture that is smaller by `divisor` to its place in the full one.
void copy_enlarged(const Image<Rgb8>& pixels, const TileRect& place, int divisor, Image<Rgb8>& picture) {
  for (int y = place.y0; y < place.y1; ++y) {
    const auto source = pixels.row(y / divisor);
    const auto target = picture.row(y);
    for (int x = place.x0; x < place.x1; ++x)
      target[static_cast<std::size_t>(x)] = source[static_cast<std::size_t>(x / divisor)];
  }
}

bool same_field(const PictureRequest& a, const PictureRequest& b) {
  return a.field == b.field || (a.field && b.field && *a.field == *b.field);
}

bool same_display(const PictureRequest& a, const PictureRequest& b) {
  return a.shown == b.shown && a.range == b.range && a.settings == b.settings;
}

}  // namespace

bool same_render(const PictureRequest& a, const PictureRequest& b) {
  if (!(a.scene.revision() == b.scene.revision()) || !(a.view == b.view) || a.region != b.region || a.slow != b.slow)
    return false;
  if (b.shown == ShownChannel::field && !same_field(a, b)) return false;
  if (a.settings == b.settings) return true;
  return std::all_of(option_table().begin(), option_table().end(), [&](const Option& option) {
    return option.effect == OptionEffect::display || option.get(a.settings) == option.get(b.settings);
  });
}

RenderWorker::RenderWorker(std::shared_ptr<Prepared> prepared, std::function<void()> wake, RenderCall render_call)
    : prepared_(std::move(prepared)), wake_(std::move(wake)),
      render_(render_call ? std::move(render_call)
                          : [](const Scene& scene, const View& view, const Settings& settings,
                               const RenderRequest& request, Prepared& kept,
                               Progress& progress) { return render(scene, view, settings, request, kept, progress); }) {
}

void RenderWorker::request(const PictureRequest& request) {
  const std::lock_guard lock(mutex_);
  const bool has_channels = (rendered_channels_ | shown_channel(request.shown).needs) == rendered_channels_;
  if (wanted_ && has_channels && state_ != RenderState::cancelled && same_render(*wanted_, request)) {
    if (same_display(*wanted_, request)) return;
    wanted_ = request;
    ++display_generation_;
    if (state_ == RenderState::done)
      job_.start([this, result = result_, generation = generation_](Progress&) {
        or_fail(generation, [&] { show_whole(result, generation); });
      });
    return;  // a running render takes the new display up by itself
  }
  const bool running = state_ == RenderState::coarse || state_ == RenderState::full;
  if (running && !whole_seen_) ++unseen_;
  wanted_ = request;
  rendered_channels_ = shown_channel(request.shown).needs | Channel::ids;
  whole_seen_ = false;
  ++generation_;
  ++display_generation_;
  ++begun_;
  requested_ = std::chrono::steady_clock::now();
  arrived_ = timed_ = false;
  state_ = RenderState::coarse;
  message_.clear();
  const Run run{request, rendered_channels_, generation_, display_generation_, next_coarse_divisor()};
  job_.start([this, run](Progress& progress) { or_fail(run.generation, [&] { render_both(run, progress); }); });
}

void RenderWorker::cancel() {
  const std::lock_guard lock(mutex_);
  if (state_ != RenderState::coarse && state_ != RenderState::full) return;
  ++generation_;
  state_ = RenderState::cancelled;
  job_.cancel();
}

RenderStatus RenderWorker::status() const {
  const std::lock_guard lock(mutex_);
  const bool running = state_ == RenderState::coarse || state_ == RenderState::full;
  double waited = 0;
  if (running && !arrived_)
    waited = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - requested_).count();
  return {state_, job_.fraction(), message_, begun_, done_, first_pixels_, waited};
}

std::shared_ptr<const RenderResult> RenderWorker::result() const {
  const std::lock_guard lock(mutex_);
  return result_;
}

ChannelLegend RenderWorker::legend() const {
  const std::lock_guard lock(mutex_);
  return legend_;
}

std::vector<TileRect> RenderWorker::collect(Image<Rgb8>& picture) {
  woken_ = false;
  news_ = false;
  const std::lock_guard lock(mutex_);
  if (arrived_ && !std::exchange(timed_, true))
    first_pixels_ = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - requested_).count();
  if (picture.width() != picture_.width() || picture.height() != picture_.height()) {
    picture = picture_;
    changed_.clear();
    if (picture.empty()) return {};
    return {whole(picture.width(), picture.height())};
  }
  for (const auto& rect : changed_)
    for (int y = rect.y0; y < rect.y1; ++y)
      std::copy_n(picture_.row(y).begin() + rect.x0, rect.width(), picture.row(y).begin() + rect.x0);
  return std::exchange(changed_, {});
}

int RenderWorker::next_coarse_divisor() const {
  if (result_ && result_->milliseconds < quick_milliseconds && unseen_ == 0) return 1;
  return std::min(2 << std::min(unseen_, 2), largest_coarse_divisor);
}

void RenderWorker::wake() {
  if (wake_ && !woken_.exchange(true)) wake_();
}

/// The newest request, or nullopt if `generation` is not the newest render.
std::optional<PictureRequest> RenderWorker::wanted(std::uint64_t generation) const {
  const std::lock_guard lock(mutex_);
  if (generation != generation_) return {};
  return wanted_;
}

/// Does the work of a render; an exception other than Cancelled becomes its message.
void RenderWorker::or_fail(std::uint64_t generation, const std::function<void()>& work) {
  try {
    work();
  } catch (const Cancelled&) {
    throw;
  } catch (const std::exception& error) {
    const std::lock_guard lock(mutex_);
    if (generation != generation_) return;
    news_ = true;
    state_ = RenderState::failed;
    message_ = failure_text(error);
  }
  wake();
}

void RenderWorker::render_both(const Run& run, Progress& progress) {
  const int divisor = run.request.slow ? 1 : run.coarse_divisor;  // the number counts in the picture as it is
  if (divisor > 1 && std::min(run.request.view.width, run.request.view.height) >= 4 * divisor)
    render_coarse(run, progress);
  render_full(run, progress);
}

void RenderWorker::render_coarse(const Run& run, Progress& progress) {
  View view = run.request.view;
  view.width = (view.width + run.coarse_divisor - 1) / run.coarse_divisor;
  view.height = (view.height + run.coarse_divisor - 1) / run.coarse_divisor;
  RenderRequest options;
  options.channels = shown_channel(run.request.shown).needs;
  options.field = run.request.field;
  options.priority = WorkerPriority::background;
  if (const auto& region = run.request.region) {
    const int d = run.coarse_divisor;
    options.region = TileRect{region->x0 / d, region->y0 / d, (region->x1 + d - 1) / d, (region->y1 + d - 1) / d};
  }
  options.on_tile = tile_publisher(run, run.coarse_divisor);
  const Frame frame = render_(run.request.scene, view, run.request.settings, options, *prepared_, progress);
  if (const auto request = wanted(run.generation); request && request->shown != ShownChannel::colour) {
    const auto picture = channel_picture(frame, request->shown, request->settings, request->range);
    publish(picture.levels, whole(view.width, view.height), run, run.coarse_divisor);
  }
  const std::lock_guard lock(mutex_);
  if (run.generation == generation_) whole_seen_ = true;
}

void RenderWorker::render_full(const Run& run, Progress& progress) {
  {
    const std::lock_guard lock(mutex_);
    if (run.generation != generation_) return;
    state_ = RenderState::full;
  }
  RenderRequest options;
  options.channels = run.channels;
  options.field = run.request.field;
  options.priority = WorkerPriority::background;
  options.region = run.request.region;
  if (run.request.slow) return render_slow(run, options, progress);
  // The renderer writes the levels of the colours that it has at hand. Those outside a region are left to the end.
  Image<Rgb8> levels;
  if (run.request.shown == ShownChannel::colour && !options.region) {
    require_image_size(run.request.view.width, run.request.view.height, "picture");
    levels = Image<Rgb8>(run.request.view.width, run.request.view.height, Unfilled{});
    options.levels = &levels;
    options.on_tile = levels_publisher(run, levels);
  } else {
    options.on_tile = tile_publisher(run, 1);
  }
  const Timer timer;
  const auto result = std::make_shared<RenderResult>();
  result->begun = std::chrono::steady_clock::now();
  result->request = run.request;
  result->channels = options.channels;
  result->frame = render_(run.request.scene, run.request.view, run.request.settings, options, *prepared_, progress);
  result->milliseconds = timer.milliseconds();
  if (options.levels && finish_shown(result, run)) return wake();
  show_whole(result, run.generation);
}

void RenderWorker::render_slow(const Run& run, const RenderRequest& options, Progress& progress) {
  const Timer timer;
  const auto result = std::make_shared<RenderResult>();
  result->begun = std::chrono::steady_clock::now();
  result->request = run.request;
  result->channels = options.channels;
  const PictureRequest& asked = run.request;
  SlowFrame slow = render_slowly(asked.scene, asked.view, asked.settings, *asked.slow, options, *prepared_, progress);
  result->frame = std::move(slow.frame);
  result->slow = std::move(slow.state);
  result->milliseconds = timer.milliseconds();
  show_whole(result, run.generation);
}

/// Hands on the levels that the renderer has made, unless another display has been asked for since.
std::function<void(const Frame&, const TileRect&)> RenderWorker::levels_publisher(const Run& run, Image<Rgb8>& levels) {
  return [this, &run, &levels](const Frame& frame, const TileRect& rect) {
    const auto request = wanted(run.generation);
    if (!request || request->shown != ShownChannel::colour) return;
    if (request->settings != run.request.settings) display_tile(frame, request->settings, rect, levels);
    publish(levels, rect, run, 1);
  };
}

/// Makes `result` the result if the tiles that have come show all of it as it is still wanted.
bool RenderWorker::finish_shown(const std::shared_ptr<const RenderResult>& result, const Run& run) {
  const std::lock_guard lock(mutex_);
  if (run.generation != generation_) return true;
  if (run.display_generation != display_generation_) return false;
  legend_ = {};
  finish(result);
  return true;
}

/// Under the lock.
void RenderWorker::finish(const std::shared_ptr<const RenderResult>& result) {
  if (result_ != result) ++done_;
  result_ = result;
  news_ = true;
  state_ = RenderState::done;
  unseen_ = 0;
}

/// Shows colours as their tiles arrive. Other channels wait for the whole picture, since their scale depends on it.
std::function<void(const Frame&, const TileRect&)> RenderWorker::tile_publisher(const Run& run, int divisor) {
  // Workers convert into tiles of their own here, and hold the lock only while they copy.
  const auto scratch = std::make_shared<Image<Rgb8>>((run.request.view.width + divisor - 1) / divisor,
                                                     (run.request.view.height + divisor - 1) / divisor);
  return [this, &run, divisor, scratch](const Frame& frame, const TileRect& rect) {
    const auto request = wanted(run.generation);
    if (!request || request->shown != ShownChannel::colour) return;
    display_tile(frame, request->settings, rect, *scratch);
    publish(*scratch, rect, run, divisor);
  };
}

void RenderWorker::publish(const Image<Rgb8>& pixels, const TileRect& rect, const Run& run, int divisor) {
  const TileRect place = enlarged(rect, divisor, run.request.view);
  {
    const std::lock_guard lock(mutex_);
    if (run.generation != generation_) return;
    if (picture_.width() != run.request.view.width || picture_.height() != run.request.view.height)
      picture_ = Image<Rgb8>(run.request.view.width, run.request.view.height, not_yet_there);
    copy_enlarged(pixels, place, divisor, picture_);
    changed_.push_back(place);
    arrived_ = true;
    news_ = true;
  }
  wake();
}

/// Makes `result` the result, shown as the newest request wants it, even if that changes on the way.
void RenderWorker::show_whole(const std::shared_ptr<const RenderResult>& result, std::uint64_t generation) {
  std::uint64_t shown_generation = 0;
  ChannelPicture picture;
  while (true) {
    PictureRequest request;
    {
      const std::lock_guard lock(mutex_);
      if (generation != generation_) return;
      if (!picture.levels.empty() && shown_generation == display_generation_) {
        picture_ = std::move(picture.levels);
        legend_ = std::move(picture.legend);
        changed_ = {whole(picture_.width(), picture_.height())};
        finish(result);
        break;
      }
      request = *wanted_;
      shown_generation = display_generation_;
    }
    picture = channel_picture(result->frame, request.shown, request.settings, request.range);
  }
  wake();
}

}  // namespace ps::gui
