// Whole pictures of the book's scenes, by both renderers, with all processors.

#include <fmt/core.h>

#include "bench/bench.h"
#include "options/option.h"
#include "options/scene_settings.h"
#include "render/render.h"
#include "scene/load.h"

namespace ps::bench {
namespace {

struct Picture {
  Scene scene;
  View view;
  Settings settings;
  Prepared prepared;
};

Job picture_job(const std::string& name, Renderer renderer) {
  const auto picture = std::make_shared<Picture>();
  picture->scene = load_scene(name);
  picture->view = {picture->scene.camera, 1280, 720};
  picture->settings = settings_for(picture->scene);
  picture->settings.renderer = renderer;
  Job job;
  job.ours = [picture] {
    Progress progress;
    render(picture->scene, picture->view, picture->settings, {}, picture->prepared, progress);
  };
  job.note = fmt::format("{} threads", resolve_threads({}));
  return job;
}

}  // namespace

Benches pictures_benches() {
  Benches benches;
  const auto add = [&](const char* label, const char* scene, Renderer renderer) {
    benches.push_back({fmt::format("picture/{}/{}/1280x720", label, scene), "ms", "",
                       [scene, renderer] { return picture_job(scene, renderer); }});
  };
  add("traced", "cgfs/reflections", Renderer::ray_tracer);
  add("traced", "cgfs/shading", Renderer::ray_tracer);
  add("rasterized", "cgfs/shading", Renderer::rasterizer);
  add("rasterized", "cgfs/crates", Renderer::rasterizer);
  add("rasterized", "cgfs/reflections", Renderer::rasterizer);
  return benches;
}

}  // namespace ps::bench
