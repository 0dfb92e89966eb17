// Shadows that a driver counts in its stencil buffer are those of the rasterizer, which counts in double precision.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "agreement/hardware/hardware_pair.h"
#include "frame/display_frame.h"
#include "hardware/gl_thread.h"
#include "image/difference.h"
#include "options/option.h"
#include "options/scene_settings.h"
#include "scene/load.h"
#include "support/render_once.h"
#include "support/settings_with.h"

namespace ps {
namespace {

constexpr int picture_side = 300;
constexpr long most_colours = 5;  ///< 20 of 360,000 pixels

struct VolumeDifference {
  long ids = 0;       ///< pixels that show another triangle
  long colours = 0;   ///< pixels of the same triangle that differ by more than one level
  long off_edge = 0;  ///< those of them that lie beside no edge of a shadow or an object
  long shadowed = 0;  ///< pixels that do not see all lights
};

/// Does a neighbour of the pixel see other lights, or another triangle?
bool at_edge(const Frame& frame, int x, int y) {
  for (int v = std::max(y - 1, 0); v <= std::min(y + 1, picture_side - 1); ++v)
    for (int u = std::max(x - 1, 0); u <= std::min(x + 1, picture_side - 1); ++u)
      if (frame.shadow.at(u, v) != frame.shadow.at(x, y) || frame.ids.at(u, v) != frame.ids.at(x, y)) return true;
  return false;
}

VolumeDifference compare(const std::string& name, const std::vector<std::string>& assignments, Renderer hardware) {
  const Scene scene = load_scene(name);
  Settings one = settings_with(
      settings_with(settings_for(scene), {"vertex-snapping=cpu", "reflection-depth=0", "environment=none"}),
      assignments);
  Settings other = one;
  one.renderer = hardware;
  other.renderer = Renderer::rasterizer;
  other.subpixel_bits = hardware::availability().driver->subpixel_bits;
  RenderRequest request;
  request.channels = Channel::ids;
  const View view{scene.camera, picture_side, picture_side};
  const Frame drawn = render(scene, view, one, request);
  request.channels = Channel::ids | Channel::shadow;
  const Frame expected = render(scene, view, other, request);
  const Image<Rgb8> a = display_frame(drawn, one), b = display_frame(expected, other);
  VolumeDifference difference;
  for (int y = 0; y < picture_side; ++y)
    for (int x = 0; x < picture_side; ++x) {
      difference.shadowed += expected.shadow.at(x, y) != 0;
      const bool same_triangle = drawn.ids.at(x, y) == expected.ids.at(x, y);
      difference.ids += !same_triangle;
      const Rgb8 p = a.at(x, y), q = b.at(x, y);
      const int levels = largest_difference(p, q);
      if (!same_triangle || levels <= 1) continue;
      ++difference.colours;
      difference.off_edge += !at_edge(expected, x, y);
    }
  fmt::print("{} {}: {} of {} pixels see not all lights; {} ids and {} colours differ, {} of them off an edge\n", name,
             fmt::join(assignments, " "), difference.shadowed, picture_side * picture_side, difference.ids,
             difference.colours, difference.off_edge);
  return difference;
}

const std::vector<std::string> shadowed_scenes{"cgfs/shadows", "octree/attenuation", "lab/inside-shadow"};

TEST(HardwareShadowVolumes, AreThoseOfTheRasterizer) {
  PS_NEEDS_HARDWARE(hardware);
  const std::vector<std::vector<std::string>> variants{
      {},
      {"shading=gouraud"},
      {"stencil-bits=1"},
      {"stencil-bits=8"},
      {"volume-caps=off"},
      {"volume-length=1"},
      {"volume-length=1e6"},
      {"far=6"},
      {"far=6", "volume-depth-clamp=off"},
      {"near=2", "depth-value=distance"},
      {"depth-format=unorm", "depth-bits=24"},
      {"projection=orthographic"},
      {"light-passes=many"},
      {"deferred-shading=on"},
      {"camera-relative=off"},
      {"backface-culling=off"},
  };
  for (const char* method : {"shadows=stencil-depth-fail", "shadows=stencil-depth-pass"})
    for (const std::vector<std::string>& variant : variants)
      for (const std::string& scene : shadowed_scenes) {
        std::vector<std::string> assignments{method};
        assignments.insert(assignments.end(), variant.begin(), variant.end());
        const VolumeDifference difference = compare(scene, assignments, hardware);
        EXPECT_LE(difference.ids, most_colours) << scene << " " << fmt::format("{}", fmt::join(assignments, " "));
        EXPECT_LE(difference.colours, most_colours) << scene << " " << fmt::format("{}", fmt::join(assignments, " "));
        EXPECT_EQ(difference.off_edge, 0) << scene << " " << fmt::format("{}", fmt::join(assignments, " "));
        if (variant.empty()) {
          EXPECT_GT(difference.shadowed, 500) << scene << ": hardly any shadow to compare";
        }
      }
}

/// A driver rounds the vertices of volumes as it rounds those of objects, so shadows end within a sub-pixel of where
/// they end in the rasterizer.
TEST(HardwareShadowVolumes, WithVerticesRoundedByTheDriverDifferOnEdgesAlone) {
  PS_NEEDS_HARDWARE(hardware);
  for (const std::string& scene : shadowed_scenes)
    EXPECT_EQ(compare(scene, {"shadows=stencil-depth-fail", "vertex-snapping=driver"}, hardware).off_edge, 0) << scene;
}

/// Not octree/attenuation: 13 of its 90,000 pixels lie within 0.001 pixels of the diagonal of the floor, which is cut
/// at the border of the picture, and its two triangles have one number.
TEST(HardwareShadowVolumes, UnderFlatShading) {
  PS_NEEDS_HARDWARE(hardware);
  for (const char* scene : {"cgfs/shadows", "lab/inside-shadow"}) {
    const VolumeDifference difference = compare(scene, {"shadows=stencil-depth-fail", "shading=flat"}, hardware);
    EXPECT_LE(difference.colours, most_colours) << scene;
    EXPECT_EQ(difference.off_edge, 0) << scene;
  }
}

/// A driver has a stencil of its own for each sample of a pixel, and the rasterizer one for its centre. So they may
/// differ where an edge of a shadow or of an object passes.
TEST(HardwareShadowVolumes, WithSeveralSamplesDifferOnEdgesAlone) {
  PS_NEEDS_HARDWARE(hardware);
  const std::vector<int>& offered = hardware::availability().driver->samples;
  if (std::find(offered.begin(), offered.end(), 4) == offered.end()) GTEST_SKIP() << "the driver has no 4 samples";
  for (const std::string& scene : shadowed_scenes) {
    const VolumeDifference difference = compare(scene, {"shadows=stencil-depth-fail", "multisampling=4"}, hardware);
    EXPECT_GT(difference.colours, 0) << scene;
    EXPECT_EQ(difference.off_edge, 0) << scene;
  }
}

}  // namespace
}  // namespace ps
