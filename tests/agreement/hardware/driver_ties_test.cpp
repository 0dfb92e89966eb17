// Samples exactly on an edge. A driver gives them to the same triangle as the rasterizer, except where it cuts a
// triangle at the border of the picture and rounds the vertices that this makes.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "agreement/hardware/hardware_pair.h"
#include "hardware/gl_thread.h"
#include "options/renderer_kind.h"
#include "render/render.h"
#include "scene/load.h"

namespace ps::driver_ties_test {
namespace {

/// Samples of triangles that two renderers may give away differently.
struct TieCount {
  long covered = 0, differ = 0;
  long ties = 0;        ///< samples exactly on an edge that one of the two covers
  double farthest = 0;  ///< of those that differ from an edge: pixels
};

enum class Reach { within_picture, beyond_it };

constexpr int tie_side = 256;

/// The distance of the pixel's centre from the nearest of the triangle's lines; points in pixels from the top left.
double distance_from_edges(const std::array<Vec2d, 3>& p, const Vec2d& centre) {
  double least = INFINITY;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec2d a = p[k], edge = p[(k + 1) % 3] - a, to = centre - a;
    least = std::min(least, std::abs(edge.x * to.y - edge.y * to.x) / std::hypot(edge.x, edge.y));
  }
  return least;
}

/// Draws triangles by hardware and rasterizer, each alone. Their vertices lie on corners or centres of pixels, 32
/// pixels apart, so that edges pass through many samples.
TieCount count_ties(Reach reach, Renderer hardware) {
  std::mt19937 random(1);
  TieCount count;
  Scene scene = load_scene("cgfs/lines");
  for (int i = 0; i < 100; ++i) {
    CanvasTriangle triangle;
    std::array<Vec2d, 3> places;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto place = [&] {
        const int step =
            reach == Reach::beyond_it ? static_cast<int>(random() % 11) - 1 : static_cast<int>(random() % 8);
        return 32 * step + (i % 2 == 0 ? 0.0 : 0.5);
      };
      places[k].x = place();
      places[k].y = place();
      triangle.points[k] = {places[k].x - tie_side / 2.0, tie_side / 2.0 - places[k].y};
      triangle.colours[k] = Vec3d(1, 0, 0);
      triangle.h[k] = 1;
    }
    scene.canvas_items.edit([&](std::vector<CanvasItem>& items) { items = {CanvasItem(triangle)}; });
    Settings settings;
    settings.subpixel_bits = hardware::availability().driver->subpixel_bits;
    const View view{scene.camera, tie_side, tie_side};
    settings.renderer = hardware;
    const Frame a = render(scene, view, settings);
    settings.renderer = renderer_for(PictureWay::fragments);
    const Frame b = render(scene, view, settings);
    const Vec3f nothing(scene.background);
    for (int y = 0; y < tie_side; ++y)
      for (int x = 0; x < tie_side; ++x) {
        const bool in_a = a.colour.at(x, y) != nothing, in_b = b.colour.at(x, y) != nothing;
        if (!in_a && !in_b) continue;
        const double distance = distance_from_edges(places, {x + 0.5, y + 0.5});
        ++count.covered;
        count.ties += distance < 1e-9;
        count.differ += in_a != in_b;
        if (in_a != in_b) count.farthest = std::max(count.farthest, distance);
      }
  }
  return count;
}

TieCount counted(Reach reach, Renderer hardware) {
  const TieCount count = count_ties(reach, hardware);
  fmt::print("{} of {} samples differ, at most {:.5f} pixels from an edge; {} ties\n", count.differ, count.covered,
             count.farthest, count.ties);
  return count;
}

TEST(HardwareTies, WithinThePictureNoneDiffers) {
  PS_NEEDS_HARDWARE(hardware);
  const TieCount count = counted(Reach::within_picture, hardware);
  EXPECT_GT(count.covered, 100000);
  EXPECT_GT(count.ties, 500);
  EXPECT_EQ(count.differ, 0);
}

TEST(HardwareTies, BeyondItOnlySamplesWithinASubPixelOfAnEdgeDiffer) {
  PS_NEEDS_HARDWARE(hardware);
  const TieCount count = counted(Reach::beyond_it, hardware);
  EXPECT_GT(count.covered, 100000);
  EXPECT_LE(count.differ, count.covered / 1000);
  EXPECT_LE(count.farthest, std::exp2(-hardware::availability().driver->subpixel_bits));
}

}  // namespace
}  // namespace ps::driver_ties_test
