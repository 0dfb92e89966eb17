#include "raytrace/slow_motion.h"

#include <algorithm>

#include "frame/pixel_order.h"
#include "frame/region.h"
#include "frame/whole_picture.h"
#include "raytrace/renderer.h"

namespace ps {
namespace {

bool is_adaptive(const Settings& settings) { return sampling_plan(settings).mode == SamplingMode::adaptive; }

/// One picture and its states.
class SlowRays {
 public:
  SlowRays(const Scene& scene, const View& view, const Settings& settings, const RenderRequest& request,
           Prepared& prepared, Progress& progress)
      : scene_(scene), view_(view), settings_(settings), request_(request), prepared_(prepared), progress_(progress),
        region_(asked_region(request, view.width, view.height)),
        order_(view.width, view.height, traced_tile_size, region_) {}

  SlowFrame after(const SlowMotion& motion) const {
    if (motion.unit == SlowUnit::samples) return after_samples(motion);
    if (is_adaptive(settings_)) return after_adaptive_pixels(motion);
    SlowFrame slow;
    const std::vector<TileRect> done = order_.done(motion, slow.state);
    slow.frame = part(whole(settings_, request_)->frame, done);
    return slow;
  }

 private:
  std::shared_ptr<const WholePicture> whole(const Settings& settings, const RenderRequest& request) const {
    return whole_picture(scene_, view_, settings, request, prepared_,
                         [&](const Settings& which, const RenderRequest& plain) {
                           return render_traced(scene_, view_, which, plain, prepared_, progress_);
                         });
  }

  Frame part(const Frame& whole, std::span<const TileRect> done) const {
    Frame frame = part_of(whole, done, scene_.background);
    if (request_.region) clear_outside(region_, frame);
    return frame;
  }

  SlowFrame after_samples(const SlowMotion& motion) const {
    SamplingPlan plan = sampling_plan(settings_);
    SlowFrame slow;
    slow.state.total = static_cast<std::uint64_t>(plan.samples);
    slow.state.done = {motion.unit, std::min(motion.at, slow.state.total)};
    if (slow.state.done.at == 0) {
      slow.frame = part(whole(settings_, request_)->frame, {});
      return slow;
    }
    plan.taken = static_cast<int>(slow.state.done.at);
    RenderRequest plain = request_;
    plain.levels = nullptr;
    plain.on_tile = {};
    slow.frame = render_planned(scene_, view_, settings_, plan, plain, prepared_, progress_);
    return slow;
  }

  /// First each pixel's first ray, then once more those pixels that are subdivided.
  SlowFrame after_adaptive_pixels(const SlowMotion& motion) const {
    Settings first = settings_;
    first.samples_per_pixel = 1;
    first.sample_pattern = SamplePattern::grid;
    first.subsampling = 1;
    RenderRequest counted = request_;
    counted.channels = counted.channels | Channel::samples;
    const auto all = whole(settings_, counted);
    const std::vector<Vec2i> again = subdivided(all->frame);
    SlowFrame slow;
    const std::uint64_t pixels = order_.count(SlowUnit::pixels);
    const std::vector<TileRect> done = order_.done({SlowUnit::pixels, std::min(motion.at, pixels)}, slow.state);
    slow.state.total = pixels + again.size();
    slow.state.done = {motion.unit, std::min(motion.at, slow.state.total)};
    slow.state.stage = "first rays";
    slow.frame = part(whole(first, counted)->frame, done);
    if (slow.state.done.at > pixels) {
      const std::span<const Vec2i> some(again.data(), slow.state.done.at - pixels);
      slow.state.stage = "subdivided pixels";
      slow.state.pixel = some.back();
      put_over(all->frame, some, slow.frame);
    }
    if (!has(request_.channels, Channel::samples)) slow.frame.samples = {};
    return slow;
  }

  /// In the order in which they are traced again.
  std::vector<Vec2i> subdivided(const Frame& frame) const {
    std::vector<Vec2i> pixels;
    for (const TileRect& tile : make_tiles(view_.width, view_.height, traced_tile_size)) {
      const TileRect part = common_part(tile, region_);
      for (int y = part.y0; y < part.y1; ++y)
        for (int x = part.x0; x < part.x1; ++x)
          if (frame.samples.at(x, y) > 1) pixels.push_back({x, y});
    }
    return pixels;
  }

  /// Stores these pixels of `whole` over those of `frame`.
  static void put_over(const Frame& whole, std::span<const Vec2i> pixels, Frame& frame) {
    std::vector<TileRect> rects;
    for (const Vec2i& pixel : pixels) rects.push_back({pixel.x, pixel.y, pixel.x + 1, pixel.y + 1});
    copy_part(whole, rects, frame);
  }

  const Scene& scene_;
  const View& view_;
  const Settings& settings_;
  const RenderRequest& request_;
  Prepared& prepared_;
  Progress& progress_;
  TileRect region_;
  PixelOrder order_;
};

}  // namespace

std::optional<std::string_view> traced_slow_motion_lacks(SlowUnit unit, const Settings& settings, const SceneTraits&) {
  switch (unit) {
  case SlowUnit::pixels:
    return {};
  case SlowUnit::tiles:
  case SlowUnit::rows:
    if (is_adaptive(settings)) return "adaptive sampling goes over the picture twice: choose pixels";
    return {};
  case SlowUnit::samples:
    if (is_adaptive(settings)) return "needs the same number of samples in every pixel: adaptive-sampling = off";
    if (settings.samples_per_pixel == 1) return "needs samples-per-pixel above 1";
    return {};
  case SlowUnit::triangles:
  case SlowUnit::fragments:
    return "rasterizer only: for rays the loop over triangles is inside the one over pixels";
  case SlowUnit::writes:
    return "listings only: here each pixel is stored once";
  }
  return {};
}

SlowFrame trace_slowly(const Scene& scene, const View& view, const Settings& settings, const SlowMotion& motion,
                       const RenderRequest& request, Prepared& prepared, Progress& progress) {
  return SlowRays(scene, view, settings, request, prepared, progress).after(motion);
}

}  // namespace ps
