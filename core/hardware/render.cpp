#include "hardware/render.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <limits>

#include "base/check.h"
#include "base/timer.h"
#include "frame/display_frame.h"
#include "frame/empty_frame.h"
#include "frame/eye_directions.h"
#include "frame/region.h"
#include "hardware/environment_maps.h"
#include "hardware/fast_path.h"
#include "hardware/kept_volumes.h"
#include "hardware/picture_drawer.h"
#include "image/display.h"

namespace ps::hardware {

const Driver& require_driver(const View& view) {
  if (!availability().driver) throw InputError(availability().reason);
  const Driver& driver = *availability().driver;
  if (std::max(view.width, view.height) > driver.max_size)
    throw InputError(fmt::format("a picture of {} x {} pixels: this graphics driver draws at most {} along a side",
                                 view.width, view.height, driver.max_size));
  // Whether there is room for a large one is better known before all else is made.
  constexpr std::int64_t large = 1 << 24;
  if (static_cast<std::int64_t>(view.width) * view.height >= large)
    on_gl_thread([&](Workshop& shop) {
      if (!shop.target || shop.target->shape().width != view.width || shop.target->shape().height != view.height)
        const Framebuffer trial({.width = view.width, .height = view.height});
    });
  return driver;
}

void draw_ahead(PicturePlan& plan, Prepared& prepared, WorkerPriority priority, Progress& progress,
                const std::function<void(const char* stage)>& done) {
  plan.shadow_maps = draw_maps(plan, prepared, priority, progress);
  if (plan.shadow_maps) done("shadow maps");
  plan.environment = draw_environment(plan, prepared, priority, progress);
  if (plan.environment) done("environment maps");
  if (!plan.counts_volumes) return;
  plan.volumes = kept_volumes(plan, prepared);
  done("shadow volumes");
}

namespace {

/// The channels that no driver fills.
void fill_rest(const View& view, const Settings& settings, Frame& frame) {
  if (!frame.direction.empty()) frame.direction = eye_directions(view, settings);
  for (std::uint32_t& samples : frame.samples.pixels()) samples = 1;
}

/// Notes how long each stage took.
class Stages {
 public:
  explicit Stages(Frame& frame) : frame_(frame) {}
  /// Milliseconds since the stage before.
  double done(const char* stage) {
    const double milliseconds = timer_.milliseconds();
    frame_.times.push_back({stage, milliseconds});
    timer_ = Timer();
    return milliseconds;
  }

 private:
  Frame& frame_;
  Timer timer_;
};

}  // namespace

Frame render_hardware(const Scene& scene, const View& view, const Settings& settings, const RenderRequest& request,
                      Prepared& prepared, Progress& progress) {
  require_driver(view);
  Frame frame = empty_frame<float>(view, request);
  Stages stages(frame);
  PicturePlan plan = make_plan(scene, view, settings, request, prepared);
  stages.done("prepare");
  draw_ahead(plan, prepared, request.priority, progress, [&](const char* stage) { stages.done(stage); });
  on_gl_thread([&](Workshop& shop) {
    shop.tidy();
    if (request.driver_memory == DriverMemory::emptied) shop.forget_scenes();
    stages.done("wait for the driver");
    PictureDrawer drawer(plan, shop);
    DriverTimes times;
    drawer.upload();
    times.upload_ms = stages.done("upload");
    drawer.draw();
    times.draw_ms = stages.done("draw");
    frame.driver = times;
    shop.target->read(frame);
    stages.done("read back");
    frame.counters[Counter::triangles_in] += drawer.triangles();
    if (sample_count(settings) == 1)
      frame.counters[Counter::pixels_written] += drawer.samples_written();
    else  // a driver counts samples and not pixels
      frame.counters.given = {Counter::triangles_in, Counter::nan_pixels};
  });
  progress.check();
  fill_rest(view, settings, frame);
  frame.counters[Counter::nan_pixels] += count_nan_pixels(frame.colour);
  frame.path = hardware_path();
  const TileRect whole{0, 0, view.width, view.height};
  if (clears_outside(request)) clear_outside(*request.region, frame);
  finish_tile(request, settings, frame, request.region.value_or(whole));
  return frame;
}

}  // namespace ps::hardware
