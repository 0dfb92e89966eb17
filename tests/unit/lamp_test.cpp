// Soft shadows of a lamp against the share of a disc that a straight edge leaves to be seen.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "options/option.h"
#include "render/story/story_tree.h"
#include "scene/load.h"
#include "scene/scene_file.h"
#include "scene/scene_text.h"
#include "support/render_once.h"

namespace ps::lamp_test {
namespace {

constexpr double radius = 0.5, height = 4, edge_height = 2;

/// A floor point below the middle of a lamp, and a half plane between the two that reaches from the left up to
/// x = `edge`. The picture's only pixel shows the point.
Scene under_a_lamp(double edge) {
  const std::string e = scene_number(edge);
  return parse_scene("viewport_size = 1 x 1\nprojection_plane_d = 1\nbackground = black\n"
                     "camera { position = (0, 1, -2)  forward = (0, -1, 2)  up = (0, 2, 1)  right = (1, 0, 0) }\n"
                     "plane { point = (0, 0, 0)  normal = (0, 1, 0)  color = white }\n"
                     "model { name = half\n  vertices { 0 = (-900, " +
                         scene_number(edge_height) + ", -900)  1 = (-900, " + scene_number(edge_height) +
                         ", 900)  2 = (" + e + ", " + scene_number(edge_height) + ", 900)  3 = (" + e + ", " +
                         scene_number(edge_height) +
                         ", -900) }\n"
                         "  triangles { 0 = { vertices = [0, 1, 2] color = black }  1 = { vertices = [0, 2, 3] color = "
                         "black } }\n}\n"
                         "instance { model = half }\n"
                         "light { type = point  intensity = 1  position = (0, " +
                         scene_number(height) + ", 0)  radius = " + scene_number(radius) + " }\n",
                     "lamp.scene", ".");
}

/// The share of a disc of radius 1 with x above c.
double share_beyond(double c) {
  if (c >= 1) return 0;
  if (c <= -1) return 1;
  return (std::acos(c) - c * std::sqrt(1 - c * c)) / std::numbers::pi;
}

double arriving(const Scene& scene, int samples, SamplePattern pattern) {
  Settings settings;
  settings.shadow_samples = samples;
  settings.shadow_pattern = pattern;
  settings.near = 0.01;
  return static_cast<double>(render(scene, {scene.camera, 1, 1}, settings, {}).colour.at(0, 0).y);
}

TEST(Lamp, PenumbraIsTheShareOfTheDisc) {
  for (const double c : {-1.2, -0.8, -0.45, -0.1, 0.25, 0.6, 0.85, 1.2}) {
    // The line to the lamp's edge at x = c * radius passes the half plane's height at half of that.
    const Scene scene = under_a_lamp(c * radius * edge_height / height);
    for (const auto& [pattern, error] : {std::pair{SamplePattern::grid, 0.035},
                                         {SamplePattern::jitter, 0.035},
                                         {SamplePattern::random, 0.1},
                                         {SamplePattern::halton, 0.035},
                                         {SamplePattern::r2, 0.035}})
      EXPECT_NEAR(arriving(scene, 256, pattern), share_beyond(c), error)
          << "edge at " << c << " of the radius, pattern " << static_cast<int>(pattern);
    EXPECT_EQ(arriving(scene, 1, SamplePattern::grid), c < 0 ? 1 : 0) << "a hard shadow";
  }
}

// Without a radius the number of samples does not count.
TEST(Lamp, APointHasOneShadowRay) {
  Scene scene = under_a_lamp(0.01);
  scene.lights.edit([](std::vector<Light>& lights) { lights[0].radius = 0; });
  Settings settings;
  settings.shadow_samples = 64;
  const Frame frame = render(scene, {scene.camera, 8, 8}, settings, {});
  EXPECT_LE(*frame.counters.get(Counter::shadow_rays), 64u);
}

TEST(Lamp, ThreadsAndTheInspectorSeeTheSameBits) {
  const Scene scene = load_scene("lab/cornell");
  const View view{scene.camera, 70, 60};
  for (const SamplePattern pattern : {SamplePattern::grid, SamplePattern::random, SamplePattern::halton}) {
    Settings settings;
    settings.shadow_samples = 5;
    settings.shadow_pattern = pattern;
    settings.near = 0.1;
    settings.threads = 1;
    const Frame one = render(scene, view, settings, {});
    for (const int threads : {2, 7}) {
      settings.threads = threads;
      const Frame more = render(scene, view, settings, {});
      EXPECT_TRUE(std::equal(one.colour.pixels().begin(), one.colour.pixels().end(), more.colour.pixels().begin()));
      EXPECT_EQ(one.counters, more.counters);
    }
    int partly = 0;
    for (int y = 1; y < 60; y += 6)
      for (int x = 1; x < 70; x += 6) {
        const PixelStory story = inspect(scene, view, settings, {x, y});
        EXPECT_EQ(Vec3f(story.linear), one.colour.at(x, y));
        int rays = 0;
        double visible = 1;
        for (const auto* ray : events_of<RayEvent>(story.events)) rays += ray->kind == RayKind::shadow;
        for (const auto* light : events_of<LightEvent>(story.events))
          if (light->kind == LightKind::point) visible = light->visible;
        if (rays > 0) {
          EXPECT_EQ(rays, 5);
        }
        partly += visible > 0 && visible < 1;
      }
    EXPECT_GT(partly, 0) << "no pixel in the penumbra";
  }
}

}  // namespace
}  // namespace ps::lamp_test
