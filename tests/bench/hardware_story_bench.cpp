// How long a click on a hardware picture waits: the story of a pixel of 200,000 triangles, drawn again by the graphics
// driver. What the driver keeps between pictures is there, as it is in the window.
#include <fmt/core.h>

#include "bench/bench.h"
#include "bench/meshes.h"
#include "options/option.h"
#include "options/renderer_kind.h"
#include "options/scene_settings.h"
#include "render/render.h"
#include "render/renderer_table.h"

namespace ps::bench {
namespace {

struct Pictured {
  Scene scene;
  View view;
  Settings settings;
  Prepared prepared;
  Vec2i pixel{0, 0};
};

/// The pixel nearest to the middle that shows the mesh.
Vec2i pixel_on_mesh(const Frame& frame) {
  const Vec2d middle(frame.ids.width() / 2, frame.ids.height() / 2);
  Vec2i best(middle);
  double least = 1e9;
  for (int y = 0; y < frame.ids.height(); ++y)
    for (int x = 0; x < frame.ids.width(); ++x) {
      const double distance = glm::length(Vec2d(x, y) - middle);
      if (frame.ids.at(x, y).object < 0 || distance >= least) continue;
      least = distance;
      best = {x, y};
    }
  return best;
}

Job story_job(Renderer hardware, const std::vector<std::string>& assignments) {
  const auto pictured = std::make_shared<Pictured>();
  const auto mesh = bench_mesh("200k");
  pictured->scene = mesh_scene(mesh);
  pictured->view = framed_view(*mesh, 1024, 768);
  pictured->settings.near = 0.01;
  pictured->settings.renderer = hardware;
  for (const std::string& assignment : assignments) parse_assignment(assignment, pictured->settings);
  Progress progress;
  RenderRequest request;
  request.channels = Channel::ids;
  const Frame frame =
      render(pictured->scene, pictured->view, pictured->settings, request, pictured->prepared, progress);
  pictured->pixel = pixel_on_mesh(frame);
  Job job;
  job.ours = [pictured] {
    Progress none;
    inspect(pictured->scene, pictured->view, pictured->settings, pictured->pixel, pictured->prepared, none);
  };
  job.note = fmt::format("pixel {},{} of 1024x768", pictured->pixel.x, pictured->pixel.y);
  return job;
}

}  // namespace

Benches hardware_story_benches() {
  const auto hardware = driver_renderer();
  if (!hardware) return {};
  const RendererKind& kind = renderer_kind(*hardware);
  if (kind.inactive && kind.inactive({}, {})) return {};
  Benches benches;
  const auto add = [&](const char* what, const std::vector<std::string>& assignments) {
    benches.push_back({fmt::format("inspect/{}-{}/200k", kind.key, what), "ms", "",
                       [hardware, assignments] { return story_job(*hardware, assignments); }});
  };
  add("plain", {});
  add("multisampling", {"multisampling=4"});
  add("deferred", {"deferred-shading=on"});
  add("shadow-map", {"shadows=map"});
  add("stencil-depth-fail", {"shadows=stencil-depth-fail"});
  add("stencil-depth-pass", {"shadows=stencil-depth-pass"});
  add("stencil-multisampling", {"shadows=stencil-depth-fail", "multisampling=4"});
  return benches;
}

}  // namespace ps::bench
