// Single pixels drawn again by the rasterizer: without replaced values bit for bit those of its picture, and with them
// what the replaced stage would have made of them.
#include "raster/pixel_replay.h"

#include <gtest/gtest.h>

#include <memory>

#include "options/option.h"
#include "options/renderer_kind.h"
#include "options/scene_settings.h"
#include "render/render.h"
#include "scene/load.h"

namespace pixel_replay_test {
namespace {
using namespace ps;

struct Replayed {
  Replayed(const std::string& name, const std::vector<std::string>& assignments)
      : scene(load_scene(name)), view{scene.camera, 60, 60}, settings(settings_for(scene)) {
    settings.renderer = renderer_for(PictureWay::fragments);
    for (const std::string& assignment : assignments) parse_assignment(assignment, settings);
    RenderRequest request;
    request.channels = Channel::ids | Channel::depth;
    frame = render(scene, view, settings, request, prepared, progress);
    replay = std::make_unique<raster::PixelReplay>(scene, view, settings, prepared, progress);
  }
  /// The triangle that a pixel shows.
  std::optional<raster::CoveringTriangle> seen(Vec2i pixel) const {
    const auto covering = replay->covering(pixel);
    const int winner = replay->winner(covering);
    if (winner < 0) return {};
    return covering[static_cast<std::size_t>(winner)];
  }

  Scene scene;
  View view;
  Settings settings;
  Prepared prepared;
  Progress progress;
  Frame frame;
  std::unique_ptr<raster::PixelReplay> replay;
};

TEST(PixelReplay, GivesThePictureBitForBit) {
  const std::vector<std::pair<std::string, std::vector<std::string>>> cases{
      {"cgfs/shading", {}},
      {"cgfs/shading", {"shading=gouraud"}},
      {"octree/attenuation", {"shading=flat"}},
      {"cgfs/crates", {}},
      {"cgfs/crates", {"visibility=painter"}},
      {"cgfs/crates", {"interpolation=affine"}},
      {"cgfs/behind", {}},
      {"cgfs/fence", {"anisotropy=4"}},
      {"cgfs/brick-wall", {}},
      {"cgfs/shadows", {"shadows=map"}},
      {"cgfs/shadows", {"shadows=stencil-depth-fail"}},
      {"lab/mirror-room", {"environment=cube-map"}},
      {"cgfs/shading", {"projection=orthographic"}}};
  for (const auto& [name, assignments] : cases) {
    const Replayed replayed(name, assignments);
    int seen = 0;
    for (int y = 0; y < replayed.view.height; ++y)
      for (int x = 0; x < replayed.view.width; ++x) {
        const auto triangle = replayed.seen({x, y});
        const Vec3f colour = triangle ? replayed.replay->shade(*triangle, {x, y}) : replayed.replay->background({x, y});
        ASSERT_EQ(colour, replayed.frame.colour.at(x, y)) << name << " " << x << "," << y;
        seen += triangle.has_value();
        ASSERT_EQ(triangle ? triangle->id.object : -1, replayed.frame.ids.at(x, y).object) << name;
      }
    EXPECT_GT(seen, 200) << name;
  }
}

TEST(PixelReplay, TakesGivenTexelsAndCoordinates) {
  const Replayed replayed("cgfs/crates", {"lighting=off", "texture-filter=bilinear"});
  int changed = 0, seen = 0;
  for (int y = 0; y < 60; y += 3)
    for (int x = 0; x < 60; x += 3) {
      const auto triangle = replayed.seen({x, y});
      if (!triangle) continue;
      ++seen;
      raster::GivenFragment texel;
      texel.surface = Vec3f(0.25f, 0.5f, 0.75f);
      EXPECT_EQ(replayed.replay->shade(*triangle, {x, y}, texel), Vec3f(0.25f, 0.5f, 0.75f));
      raster::GivenFragment elsewhere;
      elsewhere.uv = Vec2f(0.02f, 0.02f);  // the frame of the crate
      const Vec3f there = replayed.replay->shade(*triangle, {x, y}, elsewhere);
      changed += there != replayed.frame.colour.at(x, y);
    }
  EXPECT_GT(seen, 50);
  EXPECT_GT(changed, seen * 9 / 10);
}

/// Of triangles that nothing cuts, the whole has what its one piece has, but for rounding to sub-pixels.
TEST(PixelReplay, TheWholeTriangleHasTheValuesOfItsPieces) {
  const Replayed replayed("cgfs/behind", {});
  int cut = 0, compared = 0;
  for (int y = 0; y < 60; ++y)
    for (int x = 0; x < 60; ++x) {
      const auto triangle = replayed.seen({x, y});
      if (!triangle) continue;
      cut += triangle->cut;
      ++compared;
      const auto whole = replayed.replay->whole_triangle_at(*triangle, {x, y});
      EXPECT_NEAR(*whole.z / replayed.frame.depth.at(x, y), 1, 0.02) << x << "," << y;
      EXPECT_GE(replayed.replay->within_edges(*triangle, {x, y}), 0);
    }
  EXPECT_GT(cut, 10);
  EXPECT_GT(compared, 100);
}

}  // namespace
}  // namespace pixel_replay_test
