// Our rasterizer beside Mesa's llvmpipe: per-pixel Phong on meshes, and filling the screen with textures. Two threads
// each; both sides end with an 8-bit picture in memory.

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "base/check.h"
#include "bench/bench.h"
#include "bench/llvmpipe/gl_scene.h"
#include "bench/meshes.h"
#include "frame/display_frame.h"
#include "image/display.h"
#include "render/render.h"

namespace ps::bench {
namespace {

/// Pixels in which two pictures differ.
struct PictureDifference {
  long coverage = 0;  ///< background in one of them only
  long colour = 0;    ///< by more than `tolerance` levels in some channel, coverage not counted
  int largest = 0;    ///< levels, coverage not counted
  long covered = 0;   ///< pixels of the first picture that are not background
  std::string text() const {
    return fmt::format("{} px covered; {} differ in coverage, {} in colour, by {} levels at most", covered, coverage,
                       colour, largest);
  }
};

PictureDifference compare_pictures(const Image<Rgb8>& ours, const Image<Rgb8>& theirs, Rgb8 background, int tolerance) {
  PS_ASSERT(ours.width() == theirs.width() && ours.height() == theirs.height(), "pictures of one size");
  PictureDifference difference;
  for (std::size_t i = 0; i < ours.pixels().size(); ++i) {
    const Rgb8 a = ours.pixels()[i], b = theirs.pixels()[i];
    difference.covered += a != background;
    if ((a == background) != (b == background)) {
      ++difference.coverage;
      continue;
    }
    const int levels = std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
    difference.largest = std::max(difference.largest, levels);
    difference.colour += levels > tolerance;
  }
  return difference;
}

/// A smooth pattern, so that the yardstick's coarser filter weights do not show.
Texture fill_texture() {
  constexpr int size = 1024;
  Image<Vec3f> texels(size, size);
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const double a = 0.5 + 0.4 * std::sin(x * 0.11) * std::cos(y * 0.07), b = 0.5 + 0.4 * std::sin((x + y) * 0.03);
      const auto level = [](double value) { return static_cast<float>(std::round(value * 255) / 255); };
      texels.at(x, y) = {level(a), level(b), level(1 - a)};
    }
  return {"pattern", "", std::make_shared<const Image<Vec3f>>(std::move(texels))};
}

struct FillScene {
  Scene scene;
  View view;
};

/// Two triangles that fill the picture, with a smooth texture (1024 x 1024, repeated 4 times across) or without. On
/// 1920 pixels 2.1 texels fall on a pixel's width, so that trilinear filtering reads two levels.
FillScene fill_scene(int width, int height, bool textured) {
  auto mesh = std::make_shared<Mesh>();
  mesh->name = "screen";
  const double x = 1.0 * width / height, repeats_x = 4, repeats_y = repeats_x * height / width;
  mesh->positions = {{-x, 1, 2}, {-x, -1, 2}, {x, -1, 2}, {x, 1, 2}};
  mesh->uvs = {{0, 0}, {0, repeats_y}, {repeats_x, repeats_y}, {repeats_x, 0}};
  for (Vec2d& uv : mesh->uvs) uv += 1.0 / 30 / 1024;  // no pixel's centre falls on the edge between two texels
  mesh->materials = {0};
  MeshTriangle lower, upper;
  // The frame is left-handed (x right, y up, z forward), in which the front turns clockwise.
  lower.position = {0, 2, 1};
  lower.uv = {0, 2, 1};
  upper.position = {0, 3, 2};
  upper.uv = {0, 3, 2};
  mesh->triangles = {lower, upper};
  Scene scene = mesh_scene(mesh);
  scene.materials.edit([&](auto& materials) {
    materials[0].colour = {1, 1, 1};
    materials[0].texture = textured ? 0 : -1;
  });
  scene.textures = Part<std::vector<Texture>>({fill_texture()});
  View view;
  view.width = width;
  view.height = height;
  view.camera.viewport_width = x;
  return {std::move(scene), view};
}

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
