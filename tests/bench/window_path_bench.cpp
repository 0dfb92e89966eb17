// A picture on its way into the window: the renderer writes display levels while it has the colours at hand, and each
// tile is copied to what the window shows (app/gui/work/render_worker.h), beside levels made from each finished tile.

#include <fmt/core.h>

#include <algorithm>
#include <memory>
#include <mutex>

#include "bench/bench.h"
#include "frame/display_frame.h"
#include "options/scene_settings.h"
#include "render/render.h"
#include "scene/load.h"

namespace ps::bench {
namespace {

struct WindowPicture {
  Scene scene;
  View view;
  Settings settings;
  Prepared prepared;
  Image<Rgb8> levels, shown;
  std::mutex mutex;

  void copy(const TileRect& rect) {
    const std::lock_guard lock(mutex);
    for (int y = rect.y0; y < rect.y1; ++y)
      std::copy_n(levels.row(y).begin() + rect.x0, rect.width(), shown.row(y).begin() + rect.x0);
  }

  void draw(RenderRequest request) {
    Progress progress;
    request.channels = Channel::ids;  // the window names what is under the pointer
    render(scene, view, settings, request, prepared, progress);
  }
  void with_the_renderer() {
    RenderRequest request;
    levels = Image<Rgb8>(view.width, view.height, Unfilled{});
    request.levels = &levels;
    request.on_tile = [&](const Frame&, const TileRect& rect) { copy(rect); };
    draw(request);
  }
  void from_finished_tiles() {
    RenderRequest request;
    levels = Image<Rgb8>(view.width, view.height, Unfilled{});
    request.on_tile = [&](const Frame& frame, const TileRect& rect) {
      display_tile(frame, settings, rect, levels);
      copy(rect);
    };
    draw(request);
  }
};

Job window_job(const char* scene, Renderer renderer) {
  const auto picture = std::make_shared<WindowPicture>();
  picture->scene = load_scene(scene);
  picture->view = {picture->scene.camera, 1920, 1080};
  picture->settings = settings_for(picture->scene);
  picture->settings.renderer = renderer;
  picture->settings.threads = 2;
  picture->shown = Image<Rgb8>(1920, 1080);
  Job job;
  job.ours = [picture] { picture->with_the_renderer(); };
  job.yardstick = [picture] { picture->from_finished_tiles(); };
  job.check = [picture]() -> std::string {
    picture->with_the_renderer();
    const Image<Rgb8> ours = picture->shown;
    picture->from_finished_tiles();
    return ours == picture->shown ? "" : "the pictures differ";
  };
  job.note = fmt::format("1920 x 1080, {}", scene);
  return job;
}

}  // namespace

Benches window_path_benches() {
  return {{"window/rasterized-crates", "ms", "from finished tiles",
           [] { return window_job("cgfs/crates", Renderer::rasterizer); }},
          {"window/rasterized-reflections", "ms", "from finished tiles",
           [] { return window_job("cgfs/reflections", Renderer::rasterizer); }},
          {"window/traced-reflections", "ms", "from finished tiles",
           [] { return window_job("cgfs/reflections", Renderer::ray_tracer); }}};
}

}  // namespace ps::bench
