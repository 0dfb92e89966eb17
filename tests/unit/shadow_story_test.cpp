// What the inspector shows of shadow maps, stencil buffers and cube maps, against the picture and against itself.
#include <gtest/gtest.h>

#include "inspect/space_model.h"
#include "options/scene_settings.h"
#include "render/story/story_tree.h"
#include "scene/load.h"
#include "support/render_once.h"
#include "support/trials.h"

namespace ps::shadow_story_test {
namespace {

constexpr int width = 120, height = 80;

struct ShadowedPicture {
  Scene scene;
  View view;
  Settings settings;
  Prepared prepared;
  Frame frame;

  explicit ShadowedPicture(const std::string& name, Shadows shadows, Environment environment = Environment::none)
      : scene(load_scene(name)), view{scene.camera, width, height}, settings(settings_for(scene)) {
    settings.renderer = Renderer::rasterizer;
    settings.shadows = shadows;
    settings.shadow_map_size = 128;
    settings.environment = environment;
    settings.environment_size = 32;
    Progress progress;
    frame = render(scene, view, settings, request_for(Channel::shadow | Channel::stencil | Channel::ids), prepared,
                   progress);
  }
  PixelStory story(Vec2i pixel) {
    Progress progress;
    return inspect(scene, view, settings, pixel, prepared, progress);
  }
};

/// Every seventh pixel that shows something.
std::vector<Vec2i> pixels_of(const Frame& frame) {
  std::vector<Vec2i> pixels;
  constexpr int step = 6 + test::trial_divisor;
  for (int y = 3; y < height; y += step)
    for (int x = 3; x < width; x += step)
      if (frame.ids.at(x, y).object >= 0) pixels.push_back({x, y});
  return pixels;
}

void expect_picture(ShadowedPicture& drawn) {
  int dark = 0;
  for (const Vec2i pixel : pixels_of(drawn.frame)) {
    const PixelStory story = drawn.story(pixel);
    ASSERT_EQ(Vec3f(story.linear), drawn.frame.colour.at(pixel.x, pixel.y)) << pixel.x << ", " << pixel.y;
    Vec3d sum(0);
    for (const LedgerLine& line : story.ledger)
      if (line.level == 0) sum += line.value;
    for (int i = 0; i < 3; ++i) ASSERT_NEAR(sum[i], story.linear[i], 1e-5);
    const bool reported_dark = story.verdict.find("lies in the shadow of light") != std::string::npos;
    if (reported_dark) {
      ++dark;
      EXPECT_NE(drawn.frame.shadow.at(pixel.x, pixel.y), 0u);
    }
  }
  if (drawn.settings.shadows != Shadows::none) {
    EXPECT_GT(dark, 5);
  }
}

TEST(ShadowStory, SaysWhatThePictureShows) {
  for (const Shadows method : {Shadows::map, Shadows::stencil_depth_fail, Shadows::stencil_depth_pass})
    for (const Shading shading : {Shading::phong, Shading::gouraud, Shading::flat}) {
      ShadowedPicture drawn("lab/inside-shadow", method);
      drawn.settings.shading = shading;
      Progress progress;
      drawn.frame = render(drawn.scene, drawn.view, drawn.settings,
                           request_for(Channel::shadow | Channel::stencil | Channel::ids), drawn.prepared, progress);
      expect_picture(drawn);
    }
}

TEST(ShadowStory, SaysWhatACubeMapShows) {
  for (const Environment kind : {Environment::cube_map, Environment::room_map}) {
    ShadowedPicture drawn("lab/mirror-room", Shadows::none, kind);
    expect_picture(drawn);
    int mirrored = 0;
    for (const Vec2i pixel : pixels_of(drawn.frame)) {
      const PixelStory story = drawn.story(pixel);
      const auto maps = events_of<EnvironmentEvent>(story.events);
      const auto mirrors = events_of<ReflectionEvent>(story.events);
      ASSERT_EQ(maps.size(), mirrors.size());
      if (maps.empty()) continue;
      ++mirrored;
      EXPECT_EQ(maps.back()->result, mirrors.back()->reflected);
      EXPECT_EQ(maps.back()->centre.x, 0);
    }
    EXPECT_GT(mirrored, 3);
  }
}

TEST(ShadowStory, StencilCountsAreTheSumOfTheirCrossings) {
  ShadowedPicture drawn("lab/stacked-shadows", Shadows::stencil_depth_fail);
  int crossed = 0;
  for (const Vec2i pixel : pixels_of(drawn.frame)) {
    const PixelStory story = drawn.story(pixel);
    const auto counts = events_of<StencilEvent>(story.events);
    ASSERT_FALSE(counts.empty());
    const StencilEvent& last = *counts.back();
    int sum = 0;
    for (const VolumeCrossing& crossing : last.crossings) {
      sum += crossing.change;
      if (crossing.change != 0) {
        EXPECT_GE(crossing.z, last.surface_z * (1 - 1e-9)) << "depth-fail counts behind";
      }
      ++crossed;
    }
    EXPECT_EQ(last.count, sum);
    EXPECT_EQ(last.stored, sum & 15);
    EXPECT_EQ(drawn.frame.stencil.at(pixel.x, pixel.y), last.stored);
  }
  EXPECT_GT(crossed, 100);
}

TEST(ShadowStory, MapsReportTheirTapsAndTheComparison) {
  ShadowedPicture drawn("lab/shadow-acne", Shadows::map);
  drawn.settings.shadow_filter = 3;
  int compared = 0;
  for (const Vec2i pixel : pixels_of(drawn.frame)) {
    const PixelStory story = drawn.story(pixel);
    for (const auto* event : events_of<ShadowMapEvent>(story.events)) {
      if (event->outside) continue;
      ASSERT_EQ(event->taps.size(), 9u);
      int lit = 0;
      for (const ShadowTap& tap : event->taps) {
        EXPECT_EQ(tap.lit, !(float(tap.stored) < float(event->depth) - float(event->bias)));
        lit += tap.lit ? 1 : 0;
      }
      EXPECT_NEAR(event->visible, lit / 9.0, 1e-6);
      EXPECT_EQ(event->taps[4].x, static_cast<int>(event->position.x));
      EXPECT_EQ(event->taps[4].y, static_cast<int>(event->position.y));
      ++compared;
    }
  }
  EXPECT_GT(compared, 20);
}

TEST(ShadowStory, SpaceShowsSilhouettesAndMaps) {
  ShadowedPicture drawn("lab/inside-shadow", Shadows::stencil_depth_fail);
  SpaceModel model = build_space(drawn.scene, drawn.view, drawn.settings, nullptr);
  EXPECT_GT(count_of(model, SpaceKind::silhouette), 4 + 4) << "floor, roof and two balls";
  EXPECT_EQ(count_of(model, SpaceKind::silhouette), count_of(model, SpaceKind::shadow_volume));
  EXPECT_EQ(count_of(model, SpaceKind::clip_plane), 5);
  drawn.settings.shadows = Shadows::map;
  model = build_space(drawn.scene, drawn.view, drawn.settings, nullptr);
  EXPECT_EQ(count_of(model, SpaceKind::shadow_map), 6) << "both ends of one beam, and its edges";
  EXPECT_EQ(count_of(model, SpaceKind::silhouette), 0);
}

// Pictures with shadows depend neither on threads nor on SIMD.
TEST(ShadowStory, PicturesAreTheSameForAnyNumberOfThreads) {
  for (const Shadows method : {Shadows::map, Shadows::stencil_depth_fail}) {
    ShadowedPicture one("cgfs/shadows", method);
    for (const int threads : {1, 3, 7}) {
      Settings settings = one.settings;
      settings.threads = threads;
      settings.simd = threads == 3 ? Simd::off : Simd::automatic;
      const Frame frame = render(one.scene, one.view, settings);
      EXPECT_EQ(frame.colour, one.frame.colour);
    }
  }
}

}  // namespace
}  // namespace ps::shadow_story_test
