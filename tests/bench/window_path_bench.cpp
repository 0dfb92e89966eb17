// A picture on its way into the window: the renderer writes display levels while it has the colours at hand, and each
// tile is copied to what the window shows (app/gui/work/render_worker.h), beside levels made from each finished tile.
// Then each built-in scene on that way, by both renderers, with all processors: by this table one sees what is slow.

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

  Frame draw(RenderRequest request) {
    Progress progress;
    request.channels = Channel::ids;  // the window names what is under the pointer
    return render(scene, view, settings, request, prepared, progress);
  }
  Frame with_the_renderer() {
    RenderRequest request;
    levels = Image<Rgb8>(view.width, view.height, Unfilled{});
    request.levels = &levels;
    request.on_tile = [&](const Frame&, const TileRect& rect) { copy(rect); };
    return draw(request);
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

std::shared_ptr<WindowPicture> window_picture(const std::string& scene, Renderer renderer, const Vec2i& size) {
  auto picture = std::make_shared<WindowPicture>();
  picture->scene = load_scene(scene);
  picture->view = {picture->scene.camera, size.x, size.y};
  picture->settings = settings_for(picture->scene);
  picture->settings.renderer = renderer;
  picture->shown = Image<Rgb8>(size.x, size.y);
  return picture;
}

Job window_job(const char* scene, Renderer renderer) {
  const auto picture = window_picture(scene, renderer, {1920, 1080});
  picture->settings.threads = 2;
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

/// The renderer's units of work: rays of all kinds, or fragments.
std::uint64_t work_of(const Frame& frame, Renderer renderer) {
  const Counters& counters = frame.counters;
  if (renderer == Renderer::rasterizer) return counters[Counter::fragments];
  return counters[Counter::eye_rays] + counters[Counter::shadow_rays] + counters[Counter::reflection_rays] +
         counters[Counter::refraction_rays];
}

/// One built-in scene; the note says which code draws it, and why no faster code does.
Job scene_job(const std::string& scene, Renderer renderer) {
  const auto picture = window_picture(scene, renderer, {1280, 720});
  const Frame frame = picture->with_the_renderer();
  Job job;
  job.ours = [picture] { picture->with_the_renderer(); };
  const double work = std::max(static_cast<double>(work_of(frame, renderer)) * 1e-6, 1e-6);  // some draw no fragment
  job.amount = work;
  job.note =
      fmt::format("{:.2f} million, {} threads, {}", work, resolve_threads({}), machinery_key(frame.path.machinery));
  if (!frame.path.reason.empty()) job.note += fmt::format(": {}", frame.path.reason);
  return job;
}

}  // namespace

Benches window_path_benches() {
  Benches benches;
  for (const BuiltinScene& scene : builtin_scenes()) {
    const std::string name = scene.name;
    benches.push_back({fmt::format("scenes/traced/{}", name), "Mray/s", "",
                       [name] { return scene_job(name, Renderer::ray_tracer); }});
    benches.push_back({fmt::format("scenes/rasterized/{}", name), "Mfrag/s", "",
                       [name] { return scene_job(name, Renderer::rasterizer); }});
  }
  append(benches, {{"window/rasterized-crates", "ms", "from finished tiles",
                    [] { return window_job("cgfs/crates", Renderer::rasterizer); }},
                   {"window/rasterized-reflections", "ms", "from finished tiles",
                    [] { return window_job("cgfs/reflections", Renderer::rasterizer); }},
                   {"window/traced-reflections", "ms", "from finished tiles",
                    [] { return window_job("cgfs/reflections", Renderer::ray_tracer); }}});
  return benches;
}

}  // namespace ps::bench
