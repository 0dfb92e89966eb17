// Tracing only a rectangle (CGPP 15.4.4), and pictures of directions (CGPP 15.4.1.2).
#include <gtest/gtest.h>

#include <cmath>

#include "frame/region.h"
#include "render/channel_picture.h"
#include "scene/load.h"
#include "support/render_once.h"

namespace ps::region_test {
namespace {

Frame rendered(const Scene& scene, const Settings& settings, const RenderRequest& request, int width = 150,
               int height = 110) {
  return render(scene, View{scene.camera, width, height}, settings, request);
}

std::vector<Settings> ways() {
  std::vector<Settings> list(6);
  list[1].subsampling = 8;
  list[2].samples_per_pixel = 4;
  list[2].sample_pattern = SamplePattern::halton;
  list[3].samples_per_pixel = 4;
  list[3].adaptive_sampling = true;
  list[4].renderer = Renderer::rasterizer;
  list[5].simd = Simd::off;
  return list;
}

TEST(Region, ShowsTheSamePixelsAndNothingElse) {
  const Scene scene = load_scene("cgfs/reflections");
  for (const Settings& settings : ways())
    for (const TileRect& region :
         {TileRect{37, 20, 90, 71}, TileRect{31, 32, 33, 33}, TileRect{0, 0, 150, 110}, TileRect{140, 100, 150, 110}}) {
      const Channel channels = Channel::ids | Channel::depth | Channel::samples;
      const Frame all = rendered(scene, settings, request_for(channels));
      const Frame part = rendered(scene, settings, request_for(channels, region));
      for (int y = 0; y < 110; ++y)
        for (int x = 0; x < 150; ++x) {
          const bool inside = x >= region.x0 && x < region.x1 && y >= region.y0 && y < region.y1;
          ASSERT_EQ(part.colour.at(x, y), inside ? all.colour.at(x, y) : Vec3f(0)) << x << " " << y;
          ASSERT_EQ(part.ids.at(x, y), inside ? all.ids.at(x, y) : PixelId{});
          ASSERT_EQ(part.samples.at(x, y), inside ? all.samples.at(x, y) : 0u);
          if (!inside) {
            ASSERT_TRUE(std::isinf(part.depth.at(x, y)));
          }
        }
    }
}

// With shadows, which both renderers store; the frame is drawn into memory that an earlier one has left.
TEST(Region, IsTheSameWhereAnythingMayLieAround) {
  const Scene scene = load_scene("cgfs/reflections");
  for (const Settings& settings : ways())
    for (const TileRect& region : {TileRect{37, 20, 90, 71}, TileRect{31, 32, 33, 33}, TileRect{140, 100, 150, 110}}) {
      const RenderRequest all_of_it = request_for(Channel::ids | Channel::shadow | Channel::depth);
      RenderRequest request = all_of_it;
      request.region = region;
      request.outside = Outside::anything;
      const Frame all = rendered(scene, settings, all_of_it), part = rendered(scene, settings, request);
      for (int y = region.y0; y < region.y1; ++y)
        for (int x = region.x0; x < region.x1; ++x) {
          ASSERT_EQ(part.colour.at(x, y), all.colour.at(x, y)) << x << " " << y;
          ASSERT_EQ(part.ids.at(x, y), all.ids.at(x, y)) << x << " " << y;
          ASSERT_EQ(part.shadow.at(x, y), all.shadow.at(x, y)) << x << " " << y;
          ASSERT_EQ(part.depth.at(x, y), all.depth.at(x, y)) << x << " " << y;
        }
    }
}

TEST(Region, TracesNoOtherPixels) {
  const Scene scene = load_scene("cgfs/reflections");
  for (const Simd simd : {Simd::off, Simd::automatic}) {
    Settings settings;
    settings.simd = simd;
    const Frame part = rendered(scene, settings, request_for(Channel::none, TileRect{37, 20, 90, 71}));
    EXPECT_EQ(part.counters[Counter::eye_rays], 53u * 51u);
    EXPECT_EQ(part.counters[Counter::pixels_written], 53u * 51u);
  }
}

// Red grows from left to right, green from the bottom to the top; the middle of an even picture lies half a pixel off
// the axis. The same for both renderers.
TEST(Direction, IsWhatTheViewportSays) {
  const Scene scene = load_scene("cgfs/spheres");  // looks along +z, viewport 1 x 1 at 1
  for (const Renderer renderer : {Renderer::ray_tracer, Renderer::rasterizer}) {
    Settings settings{.renderer = renderer};
    const Frame frame = rendered(scene, settings, request_for(Channel::direction), 64, 64);
    for (int y = 0; y < 64; y += 9)
      for (int x = 0; x < 64; x += 7) {
        const Vec3d d{(x + 0.5) / 64 - 0.5, 0.5 - (y + 0.5) / 64, 1};
        const Vec3d expected = d / std::sqrt(dot(d, d));
        const Vec3f got = frame.direction.at(x, y);
        for (int k = 0; k < 3; ++k) EXPECT_NEAR(got[k], expected[k], 1e-6);
      }
    const auto picture = channel_picture(frame, ShownChannel::direction, settings).levels;
    EXPECT_GT(picture.at(63, 32).r, picture.at(0, 32).r + 100);
    EXPECT_GT(picture.at(32, 0).g, picture.at(32, 63).g + 100);
  }
}

}  // namespace
}  // namespace ps::region_test
