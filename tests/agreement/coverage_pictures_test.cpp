// All coverage strategies draw one picture: the fast path's, to the last bit.
#include <gtest/gtest.h>

#include "options/scene_settings.h"
#include "raster/clear/coverage/efficiency.h"
#include "render/story/story_tree.h"
#include "scene/load.h"
#include "support/render_once.h"

namespace ps::coverage_pictures_test {
namespace {

constexpr std::array<Coverage, 9> all{Coverage::edge_function, Coverage::ray_test, Coverage::bounding_box,
                                      Coverage::barycentric,   Coverage::hoisted,  Coverage::scanline,
                                      Coverage::hierarchical,  Coverage::tiled,    Coverage::micropolygon};

struct Pictures {
  Scene scene;
  View view;
  Settings settings;

  Pictures(const std::string& name, int width, int height) : scene(load_scene(name)) {
    settings = settings_for(scene);
    settings.renderer = Renderer::rasterizer;
    view = {scene.camera, width, height};
  }
  Frame draw() const { return render(scene, view, settings); }
};

int differing(const Frame& a, const Frame& b) {
  int count = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) count += a.colour.at(x, y) != b.colour.at(x, y);
  return count;
}

TEST(CoveragePictures, AreOne) {
  for (const char* name : {"cgfs/shading", "cgfs/depth", "cgfs/cubes", "cgpp/teapot"})
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
      Pictures pictures(name, 150, 110);
      pictures.settings.projection = projection;
      const Frame reference = pictures.draw();
      for (const Coverage strategy : all) {
        SCOPED_TRACE(std::string(name) + ", strategy " + std::to_string(static_cast<int>(strategy)));
        pictures.settings.coverage = strategy;
        const Frame frame = pictures.draw();
        // Float weights may round to the wrong side of an edge: a pixel or two on borders.
        const bool weights = strategy == Coverage::barycentric || strategy == Coverage::hoisted;
        EXPECT_LE(differing(frame, reference), weights ? 3 : 0);
        if (!weights) {
          EXPECT_EQ(frame.counters[Counter::fragments], reference.counters[Counter::fragments]);
        }
      }
    }
}

TEST(CoveragePictures, BarycentricInDoubleIsExact) {
  Pictures pictures("cgfs/shading", 150, 110);
  pictures.settings.precision = Precision::float64;
  const Frame reference = pictures.draw();
  for (const Coverage strategy : {Coverage::barycentric, Coverage::hoisted}) {
    pictures.settings.coverage = strategy;
    EXPECT_EQ(differing(pictures.draw(), reference), 0);
  }
}

TEST(CoveragePictures, ChannelOfTestsAddsUpToTheCounter) {
  Pictures pictures("cgfs/cubes", 100, 80);
  for (const Coverage strategy :
       {Coverage::edge_function, Coverage::ray_test, Coverage::barycentric, Coverage::hoisted}) {
    pictures.settings.coverage = strategy;
    const Frame frame = render(pictures.scene, pictures.view, pictures.settings, request_for(Channel::tests));
    std::uint64_t sum = 0;
    for (const std::uint32_t tests : frame.tests.pixels()) sum += tests;
    EXPECT_EQ(sum, frame.counters[Counter::coverage_tests]);
    if (strategy == Coverage::ray_test) {
      EXPECT_EQ(sum, frame.counters[Counter::triangles_drawn] * 100 * 80);
    }
    EXPECT_NEAR(*raster::sample_test_efficiency(frame.counters),
                static_cast<double>(frame.counters[Counter::fragments]) / static_cast<double>(sum), 1e-12);
  }
}

TEST(CoveragePictures, StoriesShowHowTheStrategyDecided) {
  Pictures pictures("cgfs/cubes", 600, 600);
  const Vec2i pixel = pictures.scene.start_pixel;
  for (const Coverage strategy : all) {
    pictures.settings.coverage = strategy;
    const Vec3f drawn = pictures.draw().colour.at(pixel.x, pixel.y);
    const PixelStory story = inspect(pictures.scene, pictures.view, pictures.settings, pixel);
    EXPECT_EQ(Vec3f(story.linear), drawn);
    int decisions = 0;
    for (const auto* decision : events_of<CoverageEvent>(story.events)) {
      ++decisions;
      EXPECT_EQ(decision->strategy, strategy);
      EXPECT_TRUE(decision->covered);
      EXPECT_GT(decision->tests, 0);
      EXPECT_FALSE(decision->how.empty());
    }
    EXPECT_EQ(decisions > 0, strategy != Coverage::edge_function);
  }
}

// Only coverage is computed in the other arithmetic: pixels that both cover are equal.
TEST(CoveragePictures, OverflowTearsLargeTrianglesAndLeavesSmallOnes) {
  Pictures pictures("cgfs/depth", 600, 600);
  const Frame reference = pictures.draw();
  pictures.settings.edge_arithmetic = EdgeArithmetic::int32;
  EXPECT_GT(differing(pictures.draw(), reference), 5000);
  pictures.view = {pictures.scene.camera, 100, 100};
  const Frame torn = pictures.draw();
  pictures.settings.edge_arithmetic = EdgeArithmetic::fixed;
  EXPECT_EQ(differing(torn, pictures.draw()), 0);
}

}  // namespace
}  // namespace ps::coverage_pictures_test
