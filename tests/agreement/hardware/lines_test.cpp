// Wireframes and points: a driver has its own rule for which pixels a line takes, so its lines lie beside ours by at
// most a pixel.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "agreement/hardware/hardware_pair.h"
#include "options/option.h"
#include "options/scene_settings.h"
#include "render/render.h"
#include "scene/load.h"
#include "support/settings_with.h"

namespace ps {
namespace {

Image<Vec3f> drawn_by(Renderer renderer, const Scene& scene, const std::string& draw) {
  Settings settings = settings_for(scene, renderer);
  parse_assignment("draw=" + draw, settings);
  return render(scene, {scene.camera, 400, 300}, settings).colour;
}

/// Pixels of `one` that are not of the background, and those of them without such a pixel of `other` within a pixel.
struct Strays {
  long drawn = 0, alone = 0;
};
Strays strays(const Image<Vec3f>& one, const Image<Vec3f>& other, const Vec3f& background) {
  Strays found;
  for (int y = 0; y < one.height(); ++y)
    for (int x = 0; x < one.width(); ++x) {
      if (one.at(x, y) == background) continue;
      ++found.drawn;
      bool near = false;
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx)
          near = near || (other.contains(x + dx, y + dy) && other.at(x + dx, y + dy) == one.at(x, y));
      found.alone += !near;
    }
  return found;
}

TEST(HardwareLines, LieWithinAPixelOfTheRasterizers) {
  PS_NEEDS_HARDWARE(hardware);
  for (const char* name : {"cgfs/cubes", "cgfs/depth", "cgpp/triangle"})
    for (const char* draw : {"wireframe", "points"}) {
      const Scene scene = load_scene(name);
      const Image<Vec3f> a = drawn_by(hardware, scene, draw), b = drawn_by(Renderer::rasterizer, scene, draw);
      const Strays ours = strays(a, b, Vec3f(scene.background)), theirs = strays(b, a, Vec3f(scene.background));
      fmt::print("{} {}: {} of {} pixels of the driver stand alone, {} of {} of the rasterizer\n", name, draw,
                 ours.alone, ours.drawn, theirs.alone, theirs.drawn);
      EXPECT_GT(ours.drawn, 0) << name << " " << draw;
      EXPECT_EQ(ours.alone, 0) << name << " " << draw;
      EXPECT_EQ(theirs.alone, 0) << name << " " << draw;
    }
}

}  // namespace
}  // namespace ps
