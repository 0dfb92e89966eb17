// The fast path of whole pictures against the clear path where sizes matter: the last tile and the last vector of a
// row, and levels that are written past the cache.
#include <random>

#include <gtest/gtest.h>

#include "frame/display_frame.h"
#include "image/display.h"
#include "options/option.h"
#include "render/render.h"
#include "support/same_bits.h"
#include "support/trials.h"
#include "support/triangle_soup.h"

namespace ps::fast_frame_test {
namespace {

using ps::test::same_bits;

Frame draw(const Scene& scene, const Settings& settings, int width, int height) {
  static Prepared prepared;  // what scenes are made into does not depend on how it is drawn
  Progress progress;
  return render(scene, {scene.camera, width, height}, settings, {}, prepared, progress);
}

/// Pictures of every width: the last tile and the last vector of a row are seldom whole.
TEST(FastFrame, DrawsEveryWidth) {
  std::mt19937 random(7);
  const Scene scene = test::triangle_soup(random);
  Settings settings{.renderer = Renderer::rasterizer};
  for (int width = 1; width < 140; width += width < 20 ? 1 : 7) {
    settings.simd = Simd::off;
    const Frame clear = draw(scene, settings, width, 66);
    settings.simd = Simd::automatic;
    EXPECT_TRUE(same_bits(clear.colour, draw(scene, settings, width, 66).colour)) << width;
  }
}

/// The levels that a caller asks for come with the tiles. Pictures too large for the cache are written past it, which
/// takes rows that begin where vectors may, and others.
TEST(FastFrame, GivesTheLevelsOfItsColours) {
  std::mt19937 random(11);
  const Scene scene = test::triangle_soup(random);
  struct Size {
    int width, height;
  };
  const std::vector<std::string> displays{"exposure=1.7", "exposure=1", "gamma=2.2", "colour-depth=16"};
  Prepared prepared;
  for (const Size size : {Size{131, 70}, {640, 600}, {603, 640}})
    for (std::size_t choice = 0; choice < displays.size(); choice += test::list_step) {
      const std::string& display = displays[choice];
      Settings settings{.renderer = Renderer::rasterizer};
      parse_assignment(display, settings);
      settings.simd = Simd::off;
      const Frame clear = draw(scene, settings, size.width, size.height);
      for (const Simd simd : {Simd::off, Simd::sse4, Simd::automatic}) {
        settings.simd = simd;
        Image<Rgb8> levels(size.width, size.height, Rgb8{1, 2, 3});
        RenderRequest request;
        request.levels = &levels;
        Progress progress;
        const View view{scene.camera, size.width, size.height};
        const Frame fast = render(scene, view, settings, request, prepared, progress);
        EXPECT_TRUE(same_bits(clear.colour, fast.colour)) << size.width << " " << display;
        std::size_t different = 0;
        for (std::size_t i = 0; i < levels.pixels().size(); ++i)
          different +=
              levels.pixels()[i] != display_pixel(Vec3d(clear.colour.pixels()[i]), display_transform(settings));
        EXPECT_EQ(different, 0u) << size.width << " " << display;
      }
    }
}

}  // namespace
}  // namespace ps::fast_frame_test
