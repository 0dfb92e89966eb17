// How the time of a rasterized picture grows with triangles and with pixels: with either, linearly.

#include <fmt/core.h>

#include "bench/bench.h"
#include "bench/meshes.h"
#include "render/render.h"

namespace ps::bench {
namespace {

struct CurvePicture {
  Scene scene;
  View view;
  Settings settings;
  Prepared prepared;
};

enum class Grows { triangles, pixels };

Job curve_job(int triangles, int width, int height, Grows what) {
  const std::shared_ptr<const Mesh> mesh = sphere_of(triangles);
  const auto picture = std::make_shared<CurvePicture>();
  picture->scene = mesh_scene(mesh);
  picture->view = framed_view(*mesh, width, height);
  picture->settings.renderer = Renderer::rasterizer;
  picture->settings.near = 0.01;
  Job job;
  job.ours = [picture] {
    Progress progress;
    render(picture->scene, picture->view, picture->settings, {}, picture->prepared, progress);
  };
  job.note = fmt::format("{} triangles", mesh->triangles.size());
  switch (what) {
  case Grows::triangles:
    job.size = static_cast<double>(mesh->triangles.size());
    break;
  case Grows::pixels:
    job.size = static_cast<double>(width) * height;
    break;
  }
  return job;
}

}  // namespace

Benches fragments_curve_benches() {
  struct Triangles {
    const char* name;
    int count;
  };
  struct Size {
    int width, height;
  };
  Benches benches;
  for (const auto& [name, count] :
       {Triangles{"1k", 1000}, {"10k", 10000}, {"100k", 100000}, {"1M", 1000000}, {"4M", 4000000}})
    benches.push_back({fmt::format("curve/fragments/triangles/{}", name), "ms", "",
                       [count = count] { return curve_job(count, 640, 480, Grows::triangles); }});
  for (const auto& [width, height] : {Size{320, 240}, {640, 480}, {1280, 960}, {2560, 1920}})
    benches.push_back({fmt::format("curve/fragments/pixels/{}x{}", width, height), "ms", "",
                       [width = width, height = height] { return curve_job(10000, width, height, Grows::pixels); }});
  return benches;
}

}  // namespace ps::bench
