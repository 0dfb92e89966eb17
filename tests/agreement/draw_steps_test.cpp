// Early depth, deferred shading, one pass for each light, multisampling: how often they shade is known in closed form
// on sheets that overlap in known orders (CGPP 15.8.3), and the picture stays what it was.
#include <gtest/gtest.h>

#include "frame/display_frame.h"
#include "image/display.h"
#include "options/option.h"
#include "options/scene_settings.h"
#include "raster/base/multisample.h"
#include "scene/load.h"
#include "support/render_once.h"
#include "support/settings_with.h"

namespace ps::draw_steps_test {
namespace {

struct Drawing {
  Scene scene;
  View view;
  Settings settings;

  explicit Drawing(const std::string& name, int size = 320) : scene(load_scene(name)) {
    settings = settings_for(scene);
    settings.renderer = Renderer::rasterizer;
    view = {scene.camera, size, size};
  }
  Frame draw(std::initializer_list<const char*> assignments, Channel channels = Channel::none) const {
    Settings changed = settings_with(settings, assignments);
    return render(scene, view, changed, request_for(channels));
  }
};

int differing(const Image<Vec3f>& a, const Image<Vec3f>& b) {
  int count = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) count += a.at(x, y) != b.at(x, y);
  return count;
}

// 320 x 320: each column is 80 x 192 pixels. From back to front all 6 sheets are shaded, from front to back 1; in the
// order 4 2 6 1 5 3 those that are nearer than all before: 4, 2 and 1.
constexpr std::uint64_t area = 80 * 192;
constexpr std::uint64_t lights = 3;

TEST(DrawSteps, ShadeAsOftenAsTheorySays) {
  const Drawing sheets("lab/depth-complexity");
  const Frame once = sheets.draw({});
  EXPECT_EQ(once.counters[Counter::fragments], 18 * area);
  EXPECT_EQ(once.counters[Counter::shading_calls], (6 + 1 + 3) * area);
  EXPECT_EQ(once.counters[Counter::light_samples], (6 + 1 + 3) * area * lights);

  const Frame early = sheets.draw({"early-depth=on"});
  EXPECT_EQ(early.counters[Counter::shading_calls], 3 * area);
  EXPECT_EQ(early.counters[Counter::fragments], 2 * 18 * area);
  EXPECT_EQ(early.counters[Counter::coverage_tests], 2 * once.counters[Counter::coverage_tests]);

  const Frame deferred = sheets.draw({"deferred-shading=on"});
  EXPECT_EQ(deferred.counters[Counter::shading_calls], 3 * area);
  EXPECT_EQ(deferred.counters[Counter::fragments], 18 * area);

  const Frame many = sheets.draw({"light-passes=many"});
  EXPECT_EQ(many.counters[Counter::shading_calls], 3 * area * lights);
  EXPECT_EQ(many.counters[Counter::light_samples], 3 * area * lights);
  EXPECT_EQ(many.counters[Counter::fragments], (1 + lights) * 18 * area);
}

TEST(DrawSteps, KeepThePicture) {
  for (const char* name : {"lab/depth-complexity", "cgfs/shading", "cgfs/crates", "cgfs/depth", "cgpp/teapot"}) {
    const Drawing drawing(name, 150);
    for (const char* format : {"depth-format=plain", "depth-format=unorm"}) {
      SCOPED_TRACE(std::string(name) + " " + format);
      const Frame reference = drawing.draw({format, "simd=off"});
      EXPECT_EQ(differing(drawing.draw({format, "early-depth=on"}).colour, reference.colour), 0);
      EXPECT_EQ(differing(drawing.draw({format, "deferred-shading=on"}).colour, reference.colour), 0);
      // Adding light by light rounds between: never by more than the last bits.
      const Frame many = drawing.draw({format, "light-passes=many"});
      for (int y = 0; y < 150; ++y)
        for (int x = 0; x < 150; ++x)
          for (int c = 0; c < 3; ++c)
            ASSERT_NEAR(many.colour.at(x, y)[c], reference.colour.at(x, y)[c], 2e-6) << x << ", " << y;
    }
  }
}

// 4 bits make many depths equal: all ways of drawing give the pixel to the same triangle. That it is the first one is
// proved in ties_test.cpp.
TEST(DrawSteps, TiesGoTheSameWay) {
  const Drawing drawing("cgfs/cubes", 150);
  const auto ids = [&](std::initializer_list<const char*> assignments) {
    return drawing.draw(assignments, Channel::ids).ids;
  };
  const auto reference = ids({"depth-format=unorm", "depth-bits=4"});
  const auto early = ids({"depth-format=unorm", "depth-bits=4", "early-depth=on"});
  const auto deferred = ids({"depth-format=unorm", "depth-bits=4", "deferred-shading=on"});
  const auto many = ids({"depth-format=unorm", "depth-bits=4", "light-passes=many"});
  for (int y = 0; y < 150; ++y)
    for (int x = 0; x < 150; ++x) {
      ASSERT_EQ(early.at(x, y), reference.at(x, y));
      ASSERT_EQ(deferred.at(x, y), reference.at(x, y));
      ASSERT_EQ(many.at(x, y), reference.at(x, y));
    }
}

TEST(DrawSteps, StoriesRepeatThePicture) {
  const Drawing drawing("lab/depth-complexity", 600);
  for (const char* how : {"early-depth=on", "deferred-shading=on", "light-passes=many", "multisampling=4"}) {
    SCOPED_TRACE(how);
    const Frame frame = drawing.draw({how});
    Settings settings = drawing.settings;
    parse_assignment(how, settings);
    for (const Vec2i pixel : {Vec2i{500, 300}, Vec2i{300, 300}, Vec2i{37, 300}, Vec2i{2, 2}}) {
      const PixelStory story = inspect(drawing.scene, drawing.view, settings, pixel);
      EXPECT_EQ(Vec3f(story.linear), frame.colour.at(pixel.x, pixel.y));
    }
  }
}

/// The white square's coverage of each pixel of a slanted edge against the sub-samples counted by hand.
TEST(Multisampling, ResolvesToTheShareOfCoveredSamples) {
  Drawing drawing("cgfs/depth", 200);
  drawing.settings.visibility = Visibility::draw_order;
  drawing.settings.lighting = false;
  Scene scene;
  scene.background = {0, 0, 0};
  auto mesh = std::make_shared<Mesh>();
  mesh->positions = {{-1.3, -1.1, 4}, {1.5, -0.7, 4}, {-0.2, 1.4, 4}};
  mesh->triangles.push_back({.position = {0, 1, 2}});
  mesh->materials = {0};
  scene.materials.edit([](std::vector<Material>& m) { m.emplace_back().colour = {1, 1, 1}; });
  scene.geometry.edit([&](Geometry& g) {
    g.meshes.push_back(mesh);
    g.objects.push_back({"triangle", Instance{}});
  });
  drawing.scene = scene;
  drawing.view = {scene.camera, 97, 97};
  drawing.settings.backface_culling = false;
  const double scale = 97;  // viewport 1 x 1 at distance 1
  std::array<Vec2d, 3> corner;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3d& p = mesh->positions[k];
    // Snapped to 1/256 pixel, as the rasterizer does by default.
    corner[k] = {std::round((48.5 + scale * p.x / p.z) * 256) / 256,
                 std::round((48.5 - scale * p.y / p.z) * 256) / 256};
  }
  const auto inside = [&](double x, double y) {
    int left = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec2d &a = corner[k], &b = corner[(k + 1) % 3];
      left += (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x) > 0;
    }
    return left == 0 || left == 3;
  };
  for (const int samples : {2, 4, 8}) {
    drawing.settings.multisampling = samples;
    const Frame frame = drawing.draw({});
    std::uint64_t pixels = 0, sub_samples = 0;
    for (int y = 0; y < 97; ++y)
      for (int x = 0; x < 97; ++x) {
        int covered = 0;
        for (const auto& s : raster::sample_pattern(samples))
          covered += inside(x + 0.5 + s.x / 16.0, y + 0.5 + s.y / 16.0);
        ASSERT_EQ(frame.colour.at(x, y).x, static_cast<float>(covered) / static_cast<float>(samples)) << x << ", " << y;
        pixels += covered > 0;
        sub_samples += static_cast<std::uint64_t>(covered);
      }
    EXPECT_EQ(frame.counters[Counter::fragments], pixels);
    EXPECT_EQ(frame.counters[Counter::subsamples], sub_samples);
    // Against the true area, edge by edge the pattern must not lean to one side.
    const double area_true = std::abs((corner[1].x - corner[0].x) * (corner[2].y - corner[0].y) -
                                      (corner[1].y - corner[0].y) * (corner[2].x - corner[0].x)) /
                             2;
    EXPECT_NEAR(static_cast<double>(sub_samples) / samples, area_true, 4);
  }
}

TEST(Multisampling, ShadesOncePerPixelAndTriangle) {
  const Drawing sheets("lab/depth-complexity");
  const Frame one = sheets.draw({}), four = sheets.draw({"multisampling=4"});
  // No sheet's border cuts a pixel; its diagonal, from (0, 0) to (80, 192), does, and then both triangles shade.
  std::uint64_t cut = 0;
  for (int y = 0; y < 192; ++y)
    for (int x = 0; x < 80; ++x) {
      int right = 0;
      for (const auto& s : raster::sample_pattern(4)) right += 192 * (16 * x + 8 + s.x) - 80 * (16 * y + 8 + s.y) >= 0;
      cut += right > 0 && right < 4;
    }
  EXPECT_GT(cut, 100u);
  EXPECT_EQ(four.counters[Counter::shading_calls], (6 + 1 + 3) * (area + cut));
  EXPECT_EQ(four.counters[Counter::subsamples], 18 * area * 4);
  for (int y = 0; y < 320; ++y)
    for (int x = 0; x < 320; ++x)
      for (int c = 0; c < 3; ++c) ASSERT_NEAR(four.colour.at(x, y)[c], one.colour.at(x, y)[c], 1e-5) << x << ", " << y;
}

TEST(Multisampling, PatternsAreRotatedGrids) {
  for (const int samples : {2, 4, 8}) {
    std::vector<int> columns, rows;
    int sum_x = 0, sum_y = 0;
    for (const auto& s : raster::sample_pattern(samples)) {
      columns.push_back((s.x + 8) * samples / 16);
      rows.push_back((s.y + 8) * samples / 16);
      sum_x += s.x;
      sum_y += s.y;
    }
    std::sort(columns.begin(), columns.end());
    std::sort(rows.begin(), rows.end());
    EXPECT_EQ(std::unique(columns.begin(), columns.end()) - columns.begin(), samples);
    EXPECT_EQ(std::unique(rows.begin(), rows.end()) - rows.begin(), samples);
    EXPECT_LE(std::abs(sum_x) + std::abs(sum_y), 4);
  }
}

}  // namespace
}  // namespace ps::draw_steps_test
