// What must hold for every scene and setting: channels change no colour, and the inspector repeats the picture's own
// bits.
#include <algorithm>
#include <array>
#include <mutex>
#include <random>

#include <gtest/gtest.h>

#include "frame/display_frame.h"
#include "image/display.h"
#include "options/option.h"
#include "render/story/story_tree.h"
#include "scene/load.h"
#include "support/render_once.h"
#include "support/same_bits.h"
#include "support/settings_with.h"
#include "support/simd_targets.h"
#include "support/trials.h"

namespace ps::rasterized_property_test {
namespace {

using ps::test::same_bits;

constexpr Channel all_channels = static_cast<Channel>(0x3ff);

Settings settings_of(const std::vector<std::string>& assignments) {
  return settings_with({.renderer = Renderer::rasterizer}, assignments);
}

const std::vector<std::pair<std::string, std::vector<std::string>>> cases{
    {"cgfs/reflections", {}},
    {"cgfs/shading", {"precision=double", "shading=gouraud", "depth-value=z"}},
    {"cgfs/shading", {"shading=flat", "normals=vertex", "visibility=painter", "backface-culling=off"}},
    {"cgfs/crates", {"interpolation=affine", "texture-filter=mipmap", "fill-rule=inclusive", "subpixel-bits=2"}},
    {"cgfs/crates", {"precision=double", "depth-value=distance", "clipping=near", "projection=orthographic"}},
    {"cgfs/cubes", {"draw=wireframe", "line-algorithm=interpolate"}},
    {"cgfs/depth", {"visibility=draw-order", "clipping=none", "precision=double"}},
    {"cgfs/mixing", {}},
    {"cgfs/lines", {"line-algorithm=bresenham", "precision=double"}},
};

Frame draw(const Scene& scene, const View& view, const Settings& settings, Channel channels = Channel::none) {
  return render(scene, view, settings, request_for(channels));
}

TEST(Rasterized, ChannelsDoNotChangeTheColour) {
  for (const auto& [name, assignments] : cases) {
    const Scene scene = load_scene(name);
    const View view{scene.camera, 200, 150};
    const Settings settings = settings_of(assignments);
    EXPECT_TRUE(same_bits(draw(scene, view, settings).colour, draw(scene, view, settings, all_channels).colour))
        << name;
  }
}

TEST(Rasterized, InspectorReportsThePicturesOwnBits) {
  constexpr unsigned seed = 404;
  std::mt19937 random(seed);
  for (const auto& [name, assignments] : cases) {
    const Scene scene = load_scene(name);
    const View view{scene.camera, 221, 260};
    const Settings settings = settings_of(assignments);
    const Frame frame = draw(scene, view, settings, Channel::overdraw);
    for (int trial = 0; trial < 40; ++trial) {
      const Vec2i pixel{std::uniform_int_distribution<int>(0, view.width - 1)(random),
                        std::uniform_int_distribution<int>(0, view.height - 1)(random)};
      const PixelStory story = inspect(scene, view, settings, pixel);
      const Vec3d expected = settings.precision == Precision::float64 ? frame.colour_double.at(pixel.x, pixel.y)
                                                                      : Vec3d(frame.colour.at(pixel.x, pixel.y));
      EXPECT_EQ(story.linear, expected) << name << " at " << pixel.x << ", " << pixel.y << ", seed " << seed;
      const Rgb8 level = display_pixel(expected, display_transform(settings));
      EXPECT_EQ(story.display, (std::array<int, 3>{level.r, level.g, level.b}));
      EXPECT_FALSE(story.verdict.empty());
      ASSERT_FALSE(story.events.empty());
      EXPECT_TRUE(std::holds_alternative<PixelEvent>(story.events.back().data));
      const auto fragments = events_of<FragmentEvent>(story.events);
      const auto drawn = fragments.size() + events_of<LineEvent>(story.events).size();
      for (const auto* fragment : fragments)
        EXPECT_NEAR(fragment->weights_2d[0] + fragment->weights_2d[1] + fragment->weights_2d[2], 1, 1e-5);
      if (name != "cgfs/mixing") {
        EXPECT_EQ(drawn, frame.overdraw.at(pixel.x, pixel.y)) << name;
      }
    }
  }
}

/// Asking for them leaves a picture on the fast path, whose stages have names of their own.
TEST(Rasterized, IdsAndDepthsAreNoReasonToBeSlow) {
  const Scene scene = load_scene("cgfs/reflections");
  const auto stage = [&](Channel channels) {
    return draw(scene, {scene.camera, 64, 64}, settings_of({}), channels).times.at(1).stage;
  };
  EXPECT_EQ(stage(Channel::ids | Channel::depth), stage(Channel::none));
  EXPECT_NE(stage(Channel::normal), stage(Channel::none));
}

TEST(Rasterized, StoryAccountsForEveryTriangle) {
  const Scene scene = load_scene("cgfs/shading");
  const Settings settings = settings_of({});
  const View view{scene.camera, 600, 600};
  for (const Vec2i pixel : {scene.start_pixel, Vec2i{300, 300}, Vec2i{0, 0}, Vec2i{150, 330}}) {
    const PixelStory story = inspect(scene, view, settings, pixel);
    const auto reported = events_of<FragmentEvent>(story.events).size() + events_of<RejectEvent>(story.events).size();
    EXPECT_EQ(reported + story.triangles_elsewhere, 474u);
  }
}

TEST(Rasterized, PaysOnlyForWhatTheSceneNeeds) {
  const Scene scene = load_scene("cgfs/shading");
  const View view{scene.camera, 200, 200};
  const Frame flat = draw(scene, view, settings_of({"lighting=off", "visibility=draw-order"}));
  EXPECT_EQ(flat.counters[Counter::attributes_interpolated], 0u);
  EXPECT_EQ(flat.counters[Counter::shading_calls], 0u);
  EXPECT_EQ(flat.counters[Counter::depth_tests], 0u);
  const Frame phong = draw(scene, view, settings_of({"visibility=draw-order"}));
  // Normal and position; no texture coordinates without a texture.
  EXPECT_EQ(phong.counters[Counter::attributes_interpolated], 6 * phong.counters[Counter::fragments]);
  EXPECT_EQ(phong.counters[Counter::shading_calls], phong.counters[Counter::fragments]);
  EXPECT_EQ(phong.counters[Counter::texel_reads], 0u);
  const Scene crates = load_scene("cgfs/crates");
  const Frame untextured = draw(crates, view, settings_of({"lighting=off", "textures=off"}));
  EXPECT_EQ(untextured.counters[Counter::attributes_interpolated], untextured.counters[Counter::depth_tests]);
  const Frame textured = draw(crates, view, settings_of({"lighting=off", "texture-filter=nearest"}));
  EXPECT_EQ(textured.counters[Counter::texel_reads], textured.counters[Counter::pixels_written]);
}

TEST(Rasterized, ReportsEachTileAndStopsWhenAsked) {
  const Scene scene = load_scene("cgfs/reflections");
  const View view{scene.camera, 200, 130};
  Prepared prepared;
  Progress progress;
  std::mutex mutex;
  std::int64_t pixels = 0;
  RenderRequest request;
  request.on_tile = [&](const Frame& frame, const TileRect& rect) {
    const std::lock_guard lock(mutex);
    EXPECT_EQ(frame.width(), 200);
    pixels += rect.width() * rect.height();
  };
  const Frame frame = render(scene, view, settings_of({}), request, prepared, progress);
  EXPECT_EQ(pixels, 200 * 130);
  EXPECT_FALSE(frame.times.empty());
  Progress stopped;
  stopped.request_stop();
  EXPECT_THROW(render(scene, view, settings_of({}), request, prepared, stopped), Cancelled);
}

/// CGFS ch. 12: halfway on the screen between z = 2 and z = 10, five sixths along, z says 8.67 where the truth is 6.
TEST(Rasterized, InterpolatesOneOverZ) {
  Scene scene;
  auto mesh = std::make_shared<Mesh>();
  // A = (-1, 0, 2) and B = (1, 0, 10), made a thin triangle; canvas x of A is -0.5, of B 0.1 of the viewport's width.
  mesh->positions = {{-1, -1e-2, 2}, {-1, 1e-2, 2}, {1, 0, 10}};
  mesh->triangles.emplace_back().position = {0, 1, 2};
  mesh->materials = {0};
  scene.materials.edit([](std::vector<Material>& m) { m.emplace_back(); });
  scene.geometry.edit([&](Geometry& g) {
    g.meshes.push_back(mesh);
    g.objects.push_back({"strip", Instance{}});
  });
  const View view{scene.camera, 600, 600};
  const auto depth_at = [&](const char* value) {
    Settings settings = settings_of({"sample-position=corner", "precision=double", "backface-culling=off",
                                     "lighting=off", std::string("depth-value=") + value});
    // The book's example: t = 5/6 of the way from x = -300 to x = 60 is x = 0.
    const PixelStory story = inspect(scene, view, settings, {300, 299});
    for (const auto* fragment : events_of<FragmentEvent>(story.events)) return fragment->depth_new.value();
    return 0.0;
  };
  EXPECT_NEAR(depth_at("z"), 8.6667, 1e-3);
  EXPECT_NEAR(1 / depth_at("inverse-z"), 6.0, 1e-6);
}

TEST(Rasterized, LowestIndexWinsTies) {
  Scene scene;
  auto mesh = std::make_shared<Mesh>();
  mesh->positions = {{-2, -2, 5}, {0, 3, 5}, {2, -2, 5}};
  for (std::uint32_t i = 0; i < 3; ++i) mesh->triangles.push_back({.position = {0, 1, 2}, .material = i});
  mesh->materials = {0, 1, 2};
  scene.materials.edit([](std::vector<Material>& m) { m.resize(3); });
  scene.geometry.edit([&](Geometry& g) {
    g.meshes.push_back(mesh);
    g.objects.push_back({"stack", Instance{}});
  });
  for (const char* how : {"visibility=depth-buffer", "visibility=painter"}) {
    const Frame frame =
        draw(scene, {scene.camera, 64, 64}, settings_of({how, "backface-culling=off", "lighting=off"}), Channel::ids);
    EXPECT_EQ(frame.ids.at(32, 32).triangle, 0) << how;
  }
}

/// A pixel inside a triangle of which only edges or corners are drawn gets the reason why it stays empty; a sphere's
/// events name the sphere, as rays' do, and keep the number of the triangle that stands for it as a detail.
TEST(Rasterized, InspectorNamesWhatPassesBy) {
  const Scene cubes = load_scene("cgfs/wireframe");
  for (const auto& [how, detail] :
       {std::pair{"draw=wireframe", "no edge passes through it"}, std::pair{"draw=points", "no vertex lies in it"}}) {
    const Settings settings = settings_of({how, "backface-culling=off"});
    const PixelStory story = inspect(cubes, {cubes.camera, 600, 600}, settings, {200, 320});
    int reported = 0;
    for (const auto* reject : events_of<RejectEvent>(story.events))
      reported += reject->reason == RejectReason::not_covered && reject->detail == detail;
    EXPECT_EQ(reported, 4) << how;  // both triangles of the front square and of the back one have it in their boxes
    EXPECT_EQ(story.triangles_elsewhere + static_cast<std::uint64_t>(reported), 24u) << how;
  }
  const Scene spheres = load_scene("cgfs/spheres");
  const PixelStory story = inspect(spheres, {spheres.camera, 600, 600}, settings_of({}), {300, 400});
  int fragments = 0;
  for (const auto* fragment : events_of<FragmentEvent>(story.events)) {
    ++fragments;
    EXPECT_EQ(fragment->id.triangle, 0);
    EXPECT_GE(fragment->sphere_triangle, 0);
  }
  EXPECT_GE(fragments, 1);
}

}  // namespace
}  // namespace ps::rasterized_property_test
