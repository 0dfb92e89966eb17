// Shapes on the canvas: filled ones as the rasterizer fills them by edge functions, lines within a pixel of its own.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "agreement/hardware/hardware_pair.h"
#include "options/option.h"
#include "render/render.h"
#include "scene/load.h"
#include "support/settings_with.h"

namespace ps {
namespace {

/// Two triangles and a polygon that cover each other, with their colours mixed in all three ways, over a sphere.
Scene filled_shapes() {
  Scene scene = load_scene("cgfs/spheres");
  scene.canvas_items.edit([](std::vector<CanvasItem>& items) {
    CanvasTriangle triangle;
    triangle.points = {Vec2d(-100.3, -80.7), Vec2d(90.2, -60), Vec2d(10, 95.55)};
    triangle.colours = {Vec3d(1, 0, 0), Vec3d(0, 1, 0), Vec3d(0, 0, 1)};
    triangle.h = {1, 0.5, 0.25};
    items.emplace_back(triangle);
    triangle.blend = Blend::additive;
    for (Vec2d& point : triangle.points) point = {-point.x, point.y + 12.3};
    items.emplace_back(triangle);
    CanvasPolygon polygon;
    polygon.blend = Blend::subtractive;
    for (const Vec2d& point : {Vec2d(-40, -90), Vec2d(60.5, -50), Vec2d(70, 40), Vec2d(-30, 60.25)})
      polygon.vertices.push_back({point, Vec3d(0.5, 0.75, 1), 1});
    items.emplace_back(polygon);
  });
  return scene;
}

TEST(HardwareCanvas, FilledShapesAreThoseOfTheRasterizer) {
  PS_NEEDS_HARDWARE(hardware);
  const Scene scene = filled_shapes();
  for (const char* sample : {"sample-position=centre", "sample-position=corner"})
    for (const char* samples : {"multisampling=1", "multisampling=4"}) {
      Settings settings =
          settings_with({}, {"vertex-snapping=cpu", "shadows=none", "reflection-depth=0", sample, samples});
      settings.renderer = hardware;
      if (inactive_value_reason(*find_option("multisampling"), settings, scene_traits(scene))) continue;
      Settings bare = settings;
      const Frame drawn = render(scene, {scene.camera, 300, 300}, bare);
      bare.renderer = Renderer::rasterizer;
      Scene without = scene;
      without.canvas_items = {};
      const Frame empty = render(without, {scene.camera, 300, 300}, bare);
      long covered = 0;
      for (std::size_t i = 0; i < drawn.colour.pixels().size(); ++i)
        covered += drawn.colour.pixels()[i] != empty.colour.pixels()[i];
      EXPECT_GT(covered, 10000);
      const auto difference = test::compare_with_rasterizer(scene, settings, hardware, 300, 300);
      fmt::print("{} {}: {}\n", sample, samples, difference.text());
      EXPECT_LE(difference.ids, 5) << sample;
      EXPECT_LE(difference.colours, 5) << sample << ", by " << difference.largest;
    }
}

/// Each pixel of either has one of the same colour in the other, at most a pixel away.
TEST(HardwareCanvas, LinesLieWithinAPixelOfTheRasterizers) {
  PS_NEEDS_HARDWARE(hardware);
  const Scene scene = load_scene("cgfs/lines");
  Settings settings;
  const View view{scene.camera, 600, 600};
  const Image<Vec3f> b = render(scene, view, (settings.renderer = Renderer::rasterizer, settings)).colour;
  const Image<Vec3f> a = render(scene, view, (settings.renderer = hardware, settings)).colour;
  const auto alone = [&](const Image<Vec3f>& one, const Image<Vec3f>& other, long& drawn) {
    long count = 0;
    for (int y = 0; y < one.height(); ++y)
      for (int x = 0; x < one.width(); ++x) {
        if (one.at(x, y) == Vec3f(scene.background)) continue;
        ++drawn;
        bool near = false;
        for (int dy = -1; dy <= 1; ++dy)
          for (int dx = -1; dx <= 1; ++dx)
            near = near || (other.contains(x + dx, y + dy) && other.at(x + dx, y + dy) == one.at(x, y));
        count += !near;
      }
    return count;
  };
  long ours = 0, theirs = 0;
  EXPECT_EQ(alone(a, b, ours), 0);
  EXPECT_EQ(alone(b, a, theirs), 0);
  fmt::print("{} pixels of the driver's lines, {} of the rasterizer's\n", ours, theirs);
  EXPECT_GT(ours, 100);
}

}  // namespace
}  // namespace ps
