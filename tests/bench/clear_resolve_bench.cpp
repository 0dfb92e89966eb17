// A picture in which nothing is seen, beside plain writing of as many bytes: what a frame costs before anything is
// drawn. Two threads each.

#include <fmt/core.h>

#include <cstring>
#include <memory>

#include "bench/bench.h"
#include "frame/display_frame.h"
#include "image/display.h"
#include "render/render.h"

namespace ps::bench {
namespace {

constexpr int writers = 2;

struct EmptyPicture {
  Scene scene;
  View view;
  Settings settings;
  Prepared prepared;
  Image<Rgb8> picture;

  /// Depth and triangle of every pixel are cleared too, tile by tile, but never leave the cache.
  void draw() {
    Progress progress;
    picture = Image<Rgb8>(view.width, view.height, Unfilled{});
    RenderRequest request;
    request.levels = &picture;
    render(scene, view, settings, request, prepared, progress);
  }
};

/// Each thread its part of both arrays, as the C library writes. Not zero, which some processors write faster.
struct PlainWriting {
  Image<Vec3f> colour;
  Image<Rgb8> levels;

  void write() {
    Progress progress;
    parallel_for(writers, {writers, WorkerPriority::normal}, progress, [&](int part, int) {
      const auto fill = [&](auto pixels) {
        const std::size_t begin = pixels.size() * static_cast<std::size_t>(part) / writers;
        const std::size_t end = pixels.size() * static_cast<std::size_t>(part + 1) / writers;
        std::memset(static_cast<void*>(pixels.data() + begin), 0x3f, (end - begin) * sizeof(pixels[0]));
      };
      fill(colour.pixels());
      fill(levels.pixels());
    });
  }
};

Job empty_job(int width, int height) {
  const auto ours = std::make_shared<EmptyPicture>();
  ours->scene.background = {0.2, 0.4, 0.6};
  ours->view.width = width;
  ours->view.height = height;
  ours->settings.renderer = Renderer::rasterizer;
  ours->settings.threads = writers;
  const auto plain = std::make_shared<PlainWriting>();
  plain->colour = Image<Vec3f>(width, height);
  plain->levels = Image<Rgb8>(width, height);
  Job job;
  job.ours = [ours] { ours->draw(); };
  job.yardstick = [plain] { plain->write(); };
  job.amount = 1e-9 * width * height * (sizeof(Vec3f) + sizeof(Rgb8));
  job.note = fmt::format("{} bytes of each pixel", sizeof(Vec3f) + sizeof(Rgb8));
  job.check = [ours] {
    ours->draw();
    const Rgb8 background = display_pixel(ours->scene.background, display_transform(ours->settings));
    for (const Rgb8 pixel : ours->picture.pixels())
      if (pixel != background) return std::string("a pixel is not the background's");
    return std::string();
  };
  return job;
}

}  // namespace

Benches clear_resolve_benches() {
  struct PictureSize {
    int width, height;
  };
  Benches benches;
  for (const auto& [width, height] : {PictureSize{1024, 768}, {1280, 720}, {1920, 1080}, {3840, 2160}})
    benches.push_back({fmt::format("fragments/clear+resolve/{}x{}", width, height), "GB/s", "memory",
                       [width = width, height = height] { return empty_job(width, height); }});
  return benches;
}

}  // namespace ps::bench
