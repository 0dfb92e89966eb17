// How long a click waits: the story of a built-in scene's start pixel by each renderer, its listing and its
// microscope, and the same on a million triangles. What is kept between renders is there, as it is in the window.

#include <fmt/core.h>

#include <optional>

#include "bench/bench.h"
#include "bench/meshes.h"
#include "inspect/microscope/microscope.h"
#include "options/scene_settings.h"
#include "render/render.h"
#include "scene/load.h"

namespace ps::bench {
namespace {

struct Inspected {
  Scene scene;
  View view;
  Settings settings;
  Prepared prepared;
  Vec2i pixel{0, 0};
  Vec2d point{0, 0};
};

enum class InspectKind {
  story,
  microscope,       ///< what is shown at once
  whole_microscope  ///< with the fine picture, which follows
};

Job inspect_job(const std::shared_ptr<Inspected>& inspected, Renderer renderer, InspectKind kind) {
  inspected->settings.renderer = renderer;
  inspected->point = Vec2d(inspected->pixel) + 0.5;
  Job job;
  job.ours = [inspected, kind] {
    Inspected& i = *inspected;
    Progress progress;
    switch (kind) {
    case InspectKind::story:
      inspect(i.scene, i.view, i.settings, i.pixel, i.prepared, progress);
      break;
    case InspectKind::microscope:
      Microscope(i.scene, i.view, i.settings, i.pixel, i.prepared, progress, MicroDetail::first)
          .read(i.point, i.prepared, progress);
      break;
    case InspectKind::whole_microscope:
      Microscope(i.scene, i.view, i.settings, i.pixel, i.prepared, progress, MicroDetail::whole)
          .read(i.point, i.prepared, progress);
      break;
    }
  };
  job.note = fmt::format("pixel {},{} of {}x{}", inspected->pixel.x, inspected->pixel.y, inspected->view.width,
                         inspected->view.height);
  return job;
}

std::shared_ptr<Inspected> builtin_scene(const std::string& name) {
  auto inspected = std::make_shared<Inspected>();
  inspected->scene = load_scene(name);
  const Scene& scene = inspected->scene;
  inspected->view = {scene.camera, scene.canvas_width, scene.canvas_height};
  inspected->settings = settings_for(scene);
  inspected->pixel =
      scene.start_pixel.x < 0 ? Vec2i{scene.canvas_width / 2, scene.canvas_height / 2} : scene.start_pixel;
  return inspected;
}

std::shared_ptr<Inspected> million_triangles() {
  auto inspected = std::make_shared<Inspected>();
  const auto mesh = bench_mesh("1M");
  inspected->scene = mesh_scene(mesh);
  inspected->view = framed_view(*mesh, 1024, 768);
  inspected->settings.near = 0.01;
  inspected->pixel = {512, 384};
  return inspected;
}

}  // namespace

Benches inspect_benches() {
  Benches benches;
  const auto add = [&](const std::string& what, const std::string& scene, auto make, Renderer renderer,
                       InspectKind kind) {
    benches.push_back(
        {fmt::format("inspect/{}/{}", what, scene), "ms", "", [=] { return inspect_job(make(), renderer, kind); }});
  };
  const auto add_all = [&](const std::string& scene, auto make) {
    add("traced", scene, make, Renderer::ray_tracer, InspectKind::story);
    add("rasterized", scene, make, Renderer::rasterizer, InspectKind::story);
    add("listing", scene, make, Renderer::textbook, InspectKind::story);
    add("microscope-traced", scene, make, Renderer::ray_tracer, InspectKind::microscope);
    add("microscope-rasterized", scene, make, Renderer::rasterizer, InspectKind::microscope);
    add("whole-microscope-traced", scene, make, Renderer::ray_tracer, InspectKind::whole_microscope);
    add("whole-microscope-rasterized", scene, make, Renderer::rasterizer, InspectKind::whole_microscope);
  };
  for (const BuiltinScene& scene : builtin_scenes())
    add_all(scene.name, [name = scene.name] { return builtin_scene(name); });
  add_all("1M", million_triangles);
  return benches;
}

}  // namespace ps::bench
