#include <algorithm>
#include <cstdlib>

#include <gtest/gtest.h>

#include "image/display.h"
#include "options/option.h"
#include "options/scene_settings.h"
#include "scene/load.h"
#include "support/emulated.h"
#include "support/render_once.h"

namespace ps::traced_rasterized_test {
namespace {

/// The two renderers' pictures of one scene, with what both can show: no shadows, no reflections.
struct Pair {
  Frame traced;
  Frame rasterized;
};

Pair draw_both(const Scene& scene, Settings settings) {
  const View view{scene.camera, scene.canvas_width, scene.canvas_height};
  RenderRequest request;
  request.channels = Channel::ids | Channel::depth;
  if (test::is_emulated())  // the middle alone; elsewhere both pictures are black
    request.region =
        TileRect{view.width / 4, view.height / 4, view.width - view.width / 4, view.height - view.height / 4};
  settings.shadows = Shadows::none;
  settings.reflection_depth = 0;
  settings.draw = Draw::filled;
  settings.backface_culling = false;
  Pair pair;
  settings.renderer = Renderer::ray_tracer;
  pair.traced = render(scene, view, settings, request);
  settings.renderer = Renderer::rasterizer;
  pair.rasterized = render(scene, view, settings, request);
  return pair;
}

/// Whether the traced picture shows more than one object or triangle within one pixel.
bool on_outline(const Frame& frame, int x, int y) {
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx)
      if (frame.ids.contains(x + dx, y + dy) && frame.ids.at(x + dx, y + dy) != frame.ids.at(x, y)) return true;
  return false;
}

int level_difference(const Rgb8& a, const Rgb8& b) {
  return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
}

/// Scenes that both renderers draw: everything but canvas items and CSG.
std::vector<std::string> scenes_in_space() {
  std::vector<std::string> names;
  for (const BuiltinScene& builtin : builtin_scenes())
    if (const Scene scene = load_scene(builtin.name); scene.canvas_items->empty() && !scene_traits(scene).csg)
      names.push_back(builtin.name);
  return names;
}

/// Scenes that show how float fails far from the origin.
bool fails_in_float(const Scene& scene) { return !settings_for(scene).camera_relative; }

class Agreement : public testing::TestWithParam<Precision> {};

TEST_P(Agreement, SameObjectsAndTrianglesExceptWithinOnePixelOfOutlines) {
  const auto names = scenes_in_space();
  ASSERT_GE(names.size(), 5u);
  for (const std::string& name : names) {
    Settings settings;
    settings.precision = GetParam();
    const Scene scene = load_scene(name);
    if (settings.precision == Precision::float32 && fails_in_float(scene)) continue;
    const Pair pair = draw_both(scene, settings);
    const std::int64_t pixels = std::int64_t{pair.traced.width()} * pair.traced.height();
    std::int64_t covered = 0, outlines = 0, differing = 0, far_off = 0;
    for (int y = 0; y < pair.traced.height(); ++y)
      for (int x = 0; x < pair.traced.width(); ++x) {
        const bool outline = on_outline(pair.traced, x, y);
        if (outline) ++outlines;
        if (pair.traced.ids.at(x, y).object >= 0) ++covered;
        if (pair.traced.ids.at(x, y) == pair.rasterized.ids.at(x, y)) continue;
        ++differing;
        if (!outline) ++far_off;
      }
    RecordProperty(name, static_cast<int>(differing));
    EXPECT_GT(covered, std::min<std::int64_t>(1000, pixels / 200)) << name;
    EXPECT_EQ(far_off, 0) << name << ": " << differing << " pixels differ in all";
    EXPECT_LT(differing, 50 + outlines / 5) << name << ": of " << outlines << " pixels along outlines";
  }
}

TEST_P(Agreement, SameColoursAwayFromOutlines) {
  for (const std::string& name : scenes_in_space()) {
    const Scene scene = load_scene(name);
    if (scene_traits(scene).textures) continue;  // rays read the finest level, fragments choose one
    Settings settings;
    settings.precision = GetParam();
    if (settings.precision == Precision::float32 && fails_in_float(scene)) continue;
    const Pair pair = draw_both(scene, settings);
    const Image<Rgb8> traced = display_image(pair.traced.colour);
    const Image<Rgb8> rasterized = display_image(pair.rasterized.colour);
    std::int64_t compared = 0, above_one = 0;
    int largest = 0;
    for (int y = 0; y < traced.height(); ++y)
      for (int x = 0; x < traced.width(); ++x) {
        if (on_outline(pair.traced, x, y)) continue;
        ++compared;
        const int difference = level_difference(traced.at(x, y), rasterized.at(x, y));
        largest = std::max(largest, difference);
        if (difference > 1) ++above_one;
      }
    EXPECT_LT(static_cast<double>(above_one), 0.004 * static_cast<double>(compared)) << name;
    EXPECT_LE(largest, 12) << name;
  }
}

INSTANTIATE_TEST_SUITE_P(Precisions, Agreement, testing::Values(Precision::float32, Precision::float64),
                         [](const auto& tested) {
                           return tested.param == Precision::float32 ? "SinglePrecision" : "DoublePrecision";
                         });

}  // namespace
}  // namespace ps::traced_rasterized_test
