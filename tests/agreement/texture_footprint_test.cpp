// Texture footprints against pictures made of many samples, and against differences between pixels.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/resources.h"
#include "options/option.h"
#include "options/scene_settings.h"
#include "scene/load.h"
#include "support/render_once.h"
#include "support/settings_with.h"
#include "textbook/listing_events.h"

namespace ps::texture_footprint_test {
namespace {

constexpr int size = 160;

Scene floor_scene() { return load_scene((chapter_dir() / "cgfs_14_mipmaps" / "floor.scene").string()); }

Settings raster_settings(const Scene& scene) {
  Settings settings = settings_for(scene, Renderer::rasterizer);
  return settings;
}

Frame draw(const Scene& scene, const Settings& settings, int side, Channel channels = Channel::none) {
  return render(scene, {scene.camera, side, side}, settings, request_for(channels));
}

/// Root mean square difference (levels of 255) of the rows right below the horizon from the mean of 16 x 16 samples.
double far_error(const Frame& frame, const Frame& fine) {
  constexpr int samples = 16;
  double sum = 0;
  int count = 0;
  for (int y = size / 2 + 2; y < size / 2 + 20; ++y)
    for (int x = 0; x < size; ++x, ++count) {
      double mean = 0;
      for (int dy = 0; dy < samples; ++dy)
        for (int dx = 0; dx < samples; ++dx) mean += fine.colour.at(x * samples + dx, y * samples + dy).x;
      const double error = 255 * (frame.colour.at(x, y).x - mean / (samples * samples));
      sum += error * error;
    }
  return std::sqrt(sum / count);
}

TEST(TextureFootprint, MoreTapsComeNearerToManySamples) {
  const Scene scene = floor_scene();
  Settings settings = raster_settings(scene);
  settings.texture_filter = TextureFilter::bilinear;
  const Frame fine = draw(scene, settings, 16 * size);
  const double bilinear = far_error(draw(scene, settings, size), fine);
  settings.texture_filter = TextureFilter::trilinear;
  std::vector<double> errors;
  for (const int taps : {1, 4, 16}) {
    settings.anisotropy = taps;
    errors.push_back(far_error(draw(scene, settings, size), fine));
  }
  std::printf("bilinear %.1f  trilinear %.1f  4 taps %.1f  16 taps %.1f levels\n", bilinear, errors[0], errors[1],
              errors[2]);
  EXPECT_LT(errors[0], bilinear);
  EXPECT_LT(errors[1], errors[0]);
  EXPECT_LT(errors[2], errors[1]);
  EXPECT_LT(errors[2], 0.5 * errors[0]);
}

// The level comes from derivatives; here from differences between a pixel's neighbours.
TEST(TextureFootprint, LevelFollowsFromDifferencesBetweenPixels) {
  const Scene scene = floor_scene();
  Settings settings = raster_settings(scene);
  settings.texture_filter = TextureFilter::trilinear;
  const Frame frame = draw(scene, settings, size, Channel::mip | Channel::uv | Channel::ids);
  constexpr double texels = 256;
  int compared = 0;
  for (int y = 1; y + 1 < size; ++y)
    for (int x = 1; x + 1 < size; ++x) {
      const float level = frame.mip.at(x, y);
      if (!(level > 0.05f) || !(level < 7.9f)) continue;  // where it is not cut to the levels that there are
      bool whole = true;
      for (const auto& [dx, dy] : {std::pair{-1, 0}, {1, 0}, {0, -1}, {0, 1}})
        whole = whole && frame.ids.at(x + dx, y + dy).object == 0;
      if (!whole) continue;
      const auto half_difference = [&](int dx, int dy) {
        const Vec2f d = frame.uv.at(x + dx, y + dy) - frame.uv.at(x - dx, y - dy);
        return texels * std::hypot(d.x, d.y) / 2;
      };
      const double expected = std::log2(std::max(half_difference(1, 0), half_difference(0, 1)));
      // Below the horizon v runs away faster than in a straight line: a difference over two pixels is a little longer.
      const double rows_below = y + 0.5 - size / 2.0;
      ASSERT_NEAR(level, expected, 2.0 / (rows_below * rows_below) + 0.01) << x << ", " << y;
      ++compared;
    }
  EXPECT_GT(compared, 1000);
}

/// The lesson's listing shares no code with the rasterizer: its weights come from directions, those of the rasterizer
/// from edges on the canvas. Compared before they are rounded, since halves of a level are frequent on this floor.
TEST(TextureFootprint, ColoursAreThoseOfTheListing) {
  const Scene scene = floor_scene();
  constexpr int side = 200;  // then the vertices are at whole pixels, and the rasterizer rounds none
  for (const char* bias : {"mip-bias=0", "mip-bias=3", "mip-bias=-1.5"}) {
    Settings listed = settings_with(settings_for(scene), {"renderer=textbook", "listing=cgfs-14-mipmaps", bias});
    const Settings drawn = settings_as_listed(listing_of(listed, scene_traits(scene)), scene, listed);
    const Frame a = draw(scene, listed, side), b = draw(scene, drawn, side);
    double most = 0, least = 1;
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) {
        const Vec3d difference = a.colour_double.at(x, y) - b.colour_double.at(x, y);
        most = std::max(most, std::sqrt(dot(difference, difference)));
        least = std::min(least, a.colour_double.at(x, y).x);
      }
    EXPECT_LT(most, 1e-6) << bias;
    EXPECT_LT(least, 0.3) << bias << ": no dark square";
  }
}

}  // namespace
}  // namespace ps::texture_footprint_test
