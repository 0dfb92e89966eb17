// Our rasterizer beside Mesa's llvmpipe: per-pixel Phong on meshes, and filling the screen with textures. Two threads
// each; both sides end with an 8-bit picture in memory.

#include <fmt/core.h>

#include "bench/bench.h"
#include "bench/llvmpipe/compare_pictures.h"
#include "bench/llvmpipe/fill_scene.h"
#include "bench/llvmpipe/gl_scene.h"
#include "bench/meshes.h"
#include "frame/display_frame.h"
#include "image/display.h"
#include "render/render.h"

namespace ps::bench {
namespace {

struct GlSides {
  Scene scene;
  View view;
  Settings settings;
  Prepared prepared;
  Image<Rgb8> picture;
  std::unique_ptr<GlScene> gl;

  void draw_ours() {
    Progress progress;
    picture = Image<Rgb8>(view.width, view.height, Unfilled{});
    RenderRequest request;
    request.levels = &picture;
    render(scene, view, settings, request, prepared, progress);
  }
};

/// Both sides on one scene. `tolerance` in levels; `share` of the pixels may differ by more, or in coverage.
Job picture_job(Scene scene, const View& view, Settings settings, int tolerance, double share) {
  settings.renderer = Renderer::rasterizer;
  settings.threads = 2;
  settings.near = 0.01;
  const auto sides = std::make_shared<GlSides>();
  sides->scene = std::move(scene);
  sides->view = view;
  sides->settings = settings;
  sides->gl = std::make_unique<GlScene>(sides->scene, view, settings);
  Job job;
  job.ours = [sides] { sides->draw_ours(); };
  job.yardstick = [sides] { sides->gl->draw(); };
  job.ours();
  job.yardstick();
  const Rgb8 background = display_pixel(sides->scene.background, {});
  const PictureDifference difference = compare_pictures(sides->picture, sides->gl->read(), background, tolerance);
  job.note = difference.text();
  const double most = share * view.width * view.height;
  job.check = [difference, most] {
    return static_cast<double>(difference.coverage + difference.colour) <= most ? "" : difference.text();
  };
  return job;
}

Job phong_job(const std::string& mesh_name, int width, int height, bool culling) {
  const std::shared_ptr<const Mesh> mesh = bench_mesh(mesh_name);
  Settings settings;
  settings.backface_culling = culling;
  return picture_job(mesh_scene(mesh), framed_view(*mesh, width, height), settings, 2, 1e-3);
}

Job fill_job(TextureFilter filter, bool textured) {
  constexpr int width = 1920, height = 1080;
  const FillScene fill = fill_scene(width, height, textured);
  Settings settings;
  settings.lighting = false;
  settings.backface_culling = false;
  settings.texture_filter = filter;
  Job job = picture_job(fill.scene, fill.view, settings, 4, 1e-3);
  job.amount = 1e-6 * width * height;
  return job;
}

}  // namespace

Benches llvmpipe_benches() {
  struct Size {
    int width, height;
  };
  struct Fill {
    const char* name;
    TextureFilter filter;
    bool textured;
  };
  Benches benches;
  for (const char* name : {"teapot", "200k", "1M"})
    for (const Size size : {Size{1024, 768}, {1920, 1080}})
      for (const bool culling : {false, true})
        benches.push_back({fmt::format("fragments/phong/{}/{}x{}/{}", name, size.width, size.height,
                                       culling ? "culling" : "no-culling"),
                           "ms", "llvmpipe", [mesh = std::string(name), size, culling] {
                             return phong_job(mesh, size.width, size.height, culling);
                           }});
  for (const auto& [name, filter, textured] : {Fill{"plain", TextureFilter::nearest, false},
                                               {"nearest", TextureFilter::nearest, true},
                                               {"bilinear", TextureFilter::bilinear, true},
                                               {"mipmap", TextureFilter::mipmap, true},
                                               {"trilinear", TextureFilter::trilinear, true}})
    benches.push_back({fmt::format("fragments/fill/{}/1920x1080", name), "Mpx/s", "llvmpipe",
                       [filter = filter, textured = textured] { return fill_job(filter, textured); }});
  return benches;
}

}  // namespace ps::bench
