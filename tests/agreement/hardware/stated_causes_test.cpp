// What assets/gallery/agreement.md and other tests say of pixels that differ, tried out: where the place that they
// blame is moved, the difference goes.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "agreement/hardware/hardware_pair.h"
#include "base/read_file.h"
#include "base/resources.h"
#include "hardware/environment_maps.h"
#include "hardware/gl_thread.h"
#include "hardware/picture_plan.h"
#include "options/option.h"
#include "options/renderer_kind.h"
#include "options/scene_settings.h"
#include "raster/environment/environment_map.h"
#include "render/render.h"
#include "scene/load.h"
#include "scene/scene_file.h"
#include "study/stage_causes.h"

namespace ps::stated_causes_test {
namespace {

StageSplit split_of(const Scene& scene, int side, Renderer hardware, const std::vector<std::string>& assignments) {
  StageRequest request;
  request.scene = scene;
  request.view = {scene.camera, side, side};
  Settings settings = settings_for(scene);
  settings.reflection_depth = 0;
  for (const std::string& assignment : assignments) parse_assignment(assignment, settings);
  settings.subpixel_bits = hardware::availability().driver->subpixel_bits;
  request.ours = request.other = settings;
  request.ours.renderer = renderer_for(PictureWay::fragments);
  request.other.renderer = hardware;
  StudyControl control;
  return split_by_stage(request, control);
}

/// A built-in scene with other words in one place of its text.
Scene changed_scene(const std::string& name, const std::string& from, const std::string& to) {
  std::string text = read_whole_file(asset_dir() / ("scenes/" + name + ".scene"));
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << name << ": " << from;
  if (at != std::string::npos) text.replace(at, from.size(), to);
  return parse_scene(text, name, {});
}

/// In a picture of 600 rows the far edge of the floor lies on the row of samples 337.5; in one of 592 it is at 333,
/// between two.
TEST(StatedCauses, AFloorThatEndsOnSamples) {
  PS_NEEDS_HARDWARE(hardware);
  if (!test::drawn_by_llvmpipe()) GTEST_SKIP() << "stated of llvmpipe, which cuts triangles at the picture's border";
  const Scene scene = load_scene("lab/inside-shadow");
  const std::vector<std::string> fail{"shadows=stencil-depth-fail"};
  EXPECT_GT(split_of(scene, 600, hardware, fail).whole.pixels, 100);
  EXPECT_LE(split_of(scene, 592, hardware, fail).whole.pixels, 20);
}

/// A floor within the picture has no border that cuts it, and the diagonal of one that reaches beyond it moves.
TEST(StatedCauses, AFloorThatThePictureCuts) {
  PS_NEEDS_HARDWARE(hardware);
  if (!test::drawn_by_llvmpipe()) GTEST_SKIP() << "stated of llvmpipe, which cuts triangles at the picture's border";
  const std::string place = "corner = (-6, -1, 1)  side_a = (12, 0, 0)  side_b = (0, 0, 12)";
  const std::vector<std::string> flat{"shadows=stencil-depth-fail", "shading=flat"};
  const auto differ = [&](const Scene& scene) { return split_of(scene, 300, hardware, flat).whole.pixels; };
  EXPECT_GT(differ(load_scene("octree/attenuation")), 5);
  EXPECT_GT(differ(changed_scene("octree/attenuation", place,
                                 "corner = (-3, -1, 3)  side_a = (6, 0, 0)  side_b = (0, 0, 10)")),
            2);
  EXPECT_EQ(differ(changed_scene("octree/attenuation", place,
                                 "corner = (-1.4, -1, 3)  side_a = (2.8, 0, 0)  side_b = (0, 0, 10)")),
            0);
}

/// Texels of environment maps that differ by more than a level.
long differing_texels(const Scene& scene, Renderer hardware) {
  Settings settings = settings_for(scene);
  for (const char* assignment : {"vertex-snapping=cpu", "shadows=none", "environment=cube-map", "environment-size=16"})
    parse_assignment(assignment, settings);
  settings.subpixel_bits = hardware::availability().driver->subpixel_bits;
  Prepared prepared;
  Progress progress;
  const auto expected = raster::environment_maps(scene, settings, prepared, WorkerPriority::normal, progress);
  settings.renderer = hardware;
  const hardware::PicturePlan plan = hardware::make_plan(scene, {scene.camera, 40, 30}, settings, {}, prepared);
  const auto drawn = hardware::draw_environment(plan, prepared, WorkerPriority::normal, progress);
  long different = 0;
  for (std::size_t i = 0; i < expected->size(); ++i)
    for (std::size_t face = 0; (*expected)[i] && face < 6; ++face) {
      const auto a = (*expected)[i]->faces[face].pixels(), b = (*drawn)[i]->faces[face].pixels();
      for (std::size_t t = 0; t < a.size(); ++t) {
        const Vec3f change = a[t] - b[t];
        different += std::max({std::abs(change.x), std::abs(change.y), std::abs(change.z)}) > 1.0f / 255;
      }
    }
  return different;
}

/// The red sphere's centre lies 0.0009 above the ground, and its map is drawn from there: a tenth higher, all agree.
TEST(StatedCauses, AMapThatIsDrawnFromTheGround) {
  PS_NEEDS_HARDWARE(hardware);
  EXPECT_GT(differing_texels(load_scene("cgfs/reflections"), hardware), 10);
  EXPECT_LE(differing_texels(changed_scene("cgfs/reflections", "(0, -1, 3)", "(0, -0.9, 3)"), hardware), 2);
}

/// Of the fragments that both renderers have at a pixel, how many codes of the depth buffer lie between them at most.
double codes_apart(const Scene& scene, Renderer hardware, int bits) {
  Settings ours = settings_for(scene);
  parse_assignment("depth-format=unorm", ours);
  ours.depth_bits = bits;
  ours.subpixel_bits = hardware::availability().driver->subpixel_bits;
  Settings theirs = ours;
  ours.renderer = Renderer::rasterizer;
  theirs.renderer = hardware;
  const View view{scene.camera, 300, 300};
  Prepared prepared;
  Progress progress;
  const double codes = std::exp2(bits) - 1;
  double most = 0;
  int compared = 0;
  for (int y = 15; y < 300; y += 30)
    for (int x = 15; x < 300; x += 30) {
      const PixelStory a = inspect(scene, view, ours, {x, y}, prepared, progress);
      const PixelStory b = inspect(scene, view, theirs, {x, y}, prepared, progress);
      for (const Event& one : a.events)
        for (const Event& other : b.events) {
          const auto* p = std::get_if<FragmentEvent>(&one.data);
          const auto* q = std::get_if<FragmentEvent>(&other.data);
          if (!p || !q || p->id != q->id) continue;
          ++compared;
          most = std::max(most, std::abs(*p->depth_new - codes * *q->depth_new));
        }
    }
  fmt::print("{} bits: {} fragments, depths at most {:.3f} codes apart\n", bits, compared, most);
  EXPECT_GT(compared, 50);
  return most;
}

/// Between 1/2 and 1 two floats are 2^-24 apart: a code of 24 bits, and a 256th of one of 16.
TEST(StatedCauses, DepthsThatAreFloats) {
  PS_NEEDS_HARDWARE(hardware);
  EXPECT_EQ(std::nextafter(1.0f, 0.0f), 1 - 0x1p-24f);
  const Scene scene = load_scene("lab/z-fighting");
  const double fine = codes_apart(scene, hardware, 24);
  EXPECT_GE(fine, 1);
  EXPECT_LE(fine, 8);
  EXPECT_LE(codes_apart(scene, hardware, 16), 1) << "the same error is smaller than a code";
}

/// Rays see another triangle in 63 pixels of the Cornell box: there the edge of floor and wall runs exactly through
/// samples, on the diagonal of the picture, and both triangles are as far away.
TEST(StatedCauses, AnEdgeOnTheDiagonalOfThePicture) {
  const Scene scene = load_scene("lab/cornell");
  constexpr int side = 300;
  const View view{scene.camera, side, side};
  RenderRequest request;
  request.channels = Channel::ids | Channel::depth;
  Prepared prepared;
  Progress progress;
  Settings settings = settings_for(scene);
  settings.renderer = renderer_for(PictureWay::rays);
  const Frame rays = render(scene, view, settings, request, prepared, progress);
  settings.renderer = renderer_for(PictureWay::fragments);
  settings.subpixel_bits = 12;
  const Frame drawn = render(scene, view, settings, request, prepared, progress);
  int differ = 0;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      if (rays.ids.at(x, y) == drawn.ids.at(x, y)) continue;
      ++differ;
      EXPECT_TRUE(x == y || x == side - 1 - y) << x << "," << y;
      EXPECT_NEAR(rays.depth.at(x, y), drawn.depth.at(x, y), 1e-5 * drawn.depth.at(x, y)) << x << "," << y;
    }
  EXPECT_GT(differ, 0);
  EXPECT_LT(differ, side);
}

}  // namespace
}  // namespace ps::stated_causes_test
