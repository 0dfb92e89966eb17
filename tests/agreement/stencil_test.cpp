// Stencil shadows where they are known to fail, against shadow rays.
#include <gtest/gtest.h>

#include <algorithm>

#include "options/scene_settings.h"
#include "scene/load.h"
#include "support/render_once.h"
#include "support/settings_with.h"

namespace ps::stencil_test {
namespace {

Frame draw(const Scene& scene, const Settings& settings) {
  return render(scene, {scene.camera, 150, 100}, settings,
                request_for(Channel::ids | Channel::shadow | Channel::stencil));
}

/// Of the pixels that show `object` in both, the share (%) whose light `light` is seen in one only.
double wrong_share(const Frame& a, const Frame& b, int object, int light) {
  int shared = 0, wrong = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) {
      if (a.ids.at(x, y).object != object || b.ids.at(x, y).object != object) continue;
      ++shared;
      if ((a.shadow.at(x, y) >> light & 1) != (b.shadow.at(x, y) >> light & 1)) ++wrong;
    }
  return shared == 0 ? -1 : 100.0 * wrong / shared;
}

Settings with(const Scene& scene, Renderer renderer, Shadows shadows) {
  Settings settings = settings_for(scene, renderer);
  settings.shadows = shadows;
  return settings;
}

// A light whose volumes are those of no object has no buffer: everything is lit, as without shadows.
TEST(Stencil, WithoutACasterEverythingIsLit) {
  Scene scene = load_scene("lab/inside-shadow");
  scene.materials.edit([](std::vector<Material>& materials) {
    for (Material& material : materials) material.transparency = 1;
  });
  const Frame lit = draw(scene, with(scene, Renderer::rasterizer, Shadows::none));
  for (const Shadows method : {Shadows::stencil_depth_fail, Shadows::stencil_depth_pass}) {
    const Settings settings = with(scene, Renderer::rasterizer, method);
    const Frame drawn = draw(scene, settings);
    EXPECT_TRUE(std::ranges::equal(drawn.colour.pixels(), lit.colour.pixels()));
    const PixelStory story = inspect(scene, {scene.camera, 150, 100}, settings, {75, 60});
    for (int i = 0; i < 3; ++i) EXPECT_EQ(story.linear[i], static_cast<double>(lit.colour.at(75, 60)[i]));
  }
}

// Inside, all is wrong but where two shadows lie over each other and one is left; outside, nothing. Depth-fail is right
// in both places.
TEST(Stencil, DepthPassIsWrongEverywhereWithTheCameraInAShadow) {
  Scene scene = load_scene("lab/inside-shadow");
  const auto share = [&](Shadows method) {
    const Frame traced = draw(scene, with(scene, Renderer::ray_tracer, Shadows::traced));
    return wrong_share(traced, draw(scene, with(scene, Renderer::rasterizer, method)), 0, 1);
  };
  EXPECT_GT(share(Shadows::stencil_depth_pass), 95);
  EXPECT_LT(share(Shadows::stencil_depth_fail), 1);
  scene.camera.position = {0, 0, -3.5};  // out of the roof's shadow
  EXPECT_LT(share(Shadows::stencil_depth_pass), 1);
  EXPECT_LT(share(Shadows::stencil_depth_fail), 1);
}

// Depth-pass loses what the near plane cuts off a volume; depth-fail does not look there.
TEST(Stencil, ANearPlaneThatCutsAVolumeSpoilsDepthPassOnly) {
  Scene scene = load_scene("lab/inside-shadow");
  scene.camera.position = {0, 0, -2.4};  // right before the roof's shadow, which begins at z = -1.6 - 0.3
  const auto share = [&](Shadows method, double near) {
    Settings settings = with(scene, Renderer::ray_tracer, Shadows::traced);
    settings.near = near;
    const Frame traced = draw(scene, settings);
    settings.renderer = Renderer::rasterizer;
    settings.shadows = method;
    return wrong_share(traced, draw(scene, settings), 0, 1);
  };
  EXPECT_LT(share(Shadows::stencil_depth_pass, 0.05), 1);
  EXPECT_GT(share(Shadows::stencil_depth_pass, 1.5), 50);
  EXPECT_LT(share(Shadows::stencil_depth_fail, 0.05), 1);
  EXPECT_LT(share(Shadows::stencil_depth_fail, 1.5), 1);
}

// Where the floor ends, the sides of its own shadow volume begin: a pixel right on that edge sees both at one depth,
// and rounding must not decide. The picture's rows are such that the far edge runs through pixel centres.
TEST(Stencil, TheEdgeOfAnObjectIsNotInItsOwnShadow) {
  Scene scene = load_scene("lab/inside-shadow");
  scene.geometry.edit([](Geometry& geometry) {
    std::erase_if(geometry.objects, [](const Object& o) { return std::holds_alternative<Sphere>(o.shape); });
  });
  const auto draw_large = [&](Renderer renderer, Shadows shadows) {
    return render(scene, {scene.camera, 300, 200}, with(scene, renderer, shadows),
                  request_for(Channel::ids | Channel::shadow));
  };
  const Frame traced = draw_large(Renderer::ray_tracer, Shadows::traced);
  const Frame drawn = draw_large(Renderer::rasterizer, Shadows::stencil_depth_fail);
  const int edge = 112;
  int on_edge = 0;
  for (int x = 0; x < 300; ++x) {
    if (drawn.ids.at(x, edge).object != 0) continue;
    ++on_edge;
    EXPECT_EQ(drawn.shadow.at(x, edge), 0u) << x;
  }
  EXPECT_GT(on_edge, 150);
  EXPECT_TRUE(drawn.ids.at(150, edge - 1).object != 0);
  EXPECT_EQ(wrong_share(traced, drawn, 0, 1), 0);
}

// A far limit that ends the floor does not end the faces of its volume, which must lie exactly on it all the same.
TEST(Stencil, AFarLimitThroughTheFloorChangesNoShadowBeforeIt) {
  const Scene scene = load_scene("lab/inside-shadow");
  const Frame traced = draw(scene, with(scene, Renderer::ray_tracer, Shadows::traced));
  for (const double far : {6.0, 9.0, 12.0, 15.0}) {
    Settings settings = with(scene, Renderer::rasterizer, Shadows::stencil_depth_fail);
    settings.far = far;
    EXPECT_LT(wrong_share(traced, draw(scene, settings), 0, 1), 1) << far;
    settings.volume_depth_clamp = false;
    EXPECT_GT(wrong_share(traced, draw(scene, settings), 0, 1), 20) << far;
  }
}

// The light falls on the roof's upper side; without it as a cap, what the line of sight leaves there is not counted.
TEST(Stencil, WithoutCapsSurfacesLieInTheirOwnShadow) {
  const Scene scene = load_scene("lab/inside-shadow");
  Settings settings = with(scene, Renderer::rasterizer, Shadows::stencil_depth_fail);
  const Frame traced = draw(scene, with(scene, Renderer::ray_tracer, Shadows::traced));
  EXPECT_LT(wrong_share(traced, draw(scene, settings), 0, 1), 1);
  settings.volume_caps = false;
  const Frame open = draw(scene, settings);
  int floor = 0;
  for (int y = 0; y < open.height(); ++y)
    for (int x = 0; x < open.width(); ++x)
      if (open.ids.at(x, y).object == 0) {
        ++floor;
        EXPECT_NE(open.shadow.at(x, y) >> 1 & 1, 0u) << x << " " << y;
      }
  EXPECT_GT(floor, open.width() * open.height() / 4);
}

/// Of the floor under exactly 16 boards, as `counts` tells, how many pixels are dark and how many there are.
struct Floor {
  int dark = 0, pixels = 0;
};
Floor under_sixteen(const Frame& counts, const Frame& frame) {
  Floor floor;
  for (int y = 0; y < frame.height(); ++y)
    for (int x = 0; x < frame.width(); ++x) {
      if (frame.ids.at(x, y).object != 0 || counts.stencil.at(x, y) != 16) continue;
      ++floor.pixels;
      if (frame.shadow.at(x, y) != 0) ++floor.dark;
    }
  return floor;
}

// A count of 4 bits comes round to 0.
TEST(Stencil, SixteenShadowsOverEachOtherAreLitInFourBits) {
  const Scene scene = load_scene("lab/stacked-shadows");
  Settings settings = settings_for(scene);
  settings.stencil_bits = 8;
  const Frame eight = draw(scene, settings);
  settings.stencil_bits = 5;
  const Frame five = draw(scene, settings);
  settings.stencil_bits = 4;
  const Frame four = draw(scene, settings);
  const Floor wide = under_sixteen(eight, eight);
  EXPECT_GT(wide.pixels, 50);
  EXPECT_EQ(wide.dark, wide.pixels);
  EXPECT_EQ(under_sixteen(eight, five).dark, wide.pixels);
  EXPECT_EQ(under_sixteen(eight, four).dark, 0);
}

}  // namespace
}  // namespace ps::stencil_test
