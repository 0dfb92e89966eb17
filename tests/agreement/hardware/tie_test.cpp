// scratch
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>

#include "agreement/hardware/hardware_pair.h"
#include "hardware/gl_thread.h"
#include "options/option.h"
#include "render/render.h"
#include "scene/load.h"

namespace ps {
namespace {

TEST(HardwareTies, Explore) {
  PS_NEEDS_HARDWARE(hardware);
  std::mt19937 random(5);
  long samples = 0, differ = 0, shown = 0;
  const int side = 256;
  for (int i = 0; i < 150; ++i) {
    Scene scene = load_scene("cgfs/lines");
    scene.canvas_items.edit([&](std::vector<CanvasItem>& items) {
      items.clear();
      CanvasTriangle triangle;
      for (auto& p : triangle.points)
        p = Vec2d(static_cast<int>(random() % (2 * side - 8)) / 2.0 - side / 2 + 2, static_cast<int>(random() % (2 * side - 8)) / 2.0 - side / 2 + 2);
      triangle.colours = {Vec3d(1, 0, 0), Vec3d(1, 0, 0), Vec3d(1, 0, 0)};
      triangle.h = {1, 1, 1};
      items.emplace_back(triangle);
    });
    Settings s;
    s.renderer = hardware;
    const View view{scene.camera, side, side};
    const Frame a = render(scene, view, s);
    s.renderer = Renderer::rasterizer;
    const Frame b = render(scene, view, s);
    long here = 0;
    const auto& t = std::get<CanvasTriangle>(scene.canvas_items->front());
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) {
        const bool pa = a.colour.at(x, y) != Vec3f(scene.background), pb = b.colour.at(x, y) != Vec3f(scene.background);
        samples += pb;
        if (pa != pb) {
          ++differ; ++here;
          if (shown++ < 60)
            fmt::print("tri {} ({},{}) ({},{}) ({},{}) px {},{} hw {} sw {}\n", i, t.points[0].x + side / 2, side / 2 - t.points[0].y,
                       t.points[1].x + side / 2, side / 2 - t.points[1].y, t.points[2].x + side / 2, side / 2 - t.points[2].y, x, y, pa, pb);
        }
      }
  }
  fmt::print("{} of {} differ\n", differ, samples);
}

}  // namespace
}  // namespace ps
