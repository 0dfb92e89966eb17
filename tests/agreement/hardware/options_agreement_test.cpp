// What the hardware renderer draws is what the rasterizer draws, for every value of every option that it honours. What
// it lacks by the option's row (HardwareUse) is the only way out.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "agreement/hardware/hardware_pair.h"
#include "hardware/environment_maps.h"
#include "hardware/gl_thread.h"
#include "hardware/lacks.h"
#include "options/option.h"
#include "options/scene_settings.h"
#include "raster/maps.h"
#include "render/render.h"
#include "scene/load.h"
#include "support/settings_with.h"

namespace ps {
namespace {

using test::PairCase;
using test::PairDifference;

constexpr int width = 600, height = 600;
constexpr long most_ids = 20;  ///< of 360,000 pixels

/// The options are compared in pictures of a quarter of that.
constexpr int option_width = 300, option_height = 300;
constexpr long most_option_ids = most_ids / 4;

/// Prints what was measured, whether the test fails or not.
PairDifference measured(const PairCase& one, Renderer hardware, int columns = width, int rows = height) {
  PairCase plain = one;
  plain.assignments.insert(plain.assignments.begin(), {"shadows=none", "reflection-depth=0", "environment=none"});
  const PairDifference difference = compare_with_rasterizer(plain, hardware, columns, rows);
  fmt::print("{}: {}\n", one.name(), difference.text());
  return difference;
}

/// Scenes with surfaces, in which nothing is left to chance: neither surfaces that fight for a depth nor textures that
/// are looked up where a line of sight grazes a relief.
const std::vector<std::string> agreement_scenes{
    "cgfs/shading",      "cgfs/reflections", "cgfs/crates",          "cgfs/cubes",    "cgfs/primitives",
    "cgfs/brick-wall",   "cgfs/fence",       "cgfs/depth",           "cgfs/behind",   "cgfs/near-light",
    "cgfs/camera",       "cgpp/teapot",      "cgpp/triangle",        "cgpp/ground",   "octree/attenuation",
    "octree/headline",   "lab/far-origin",   "lab/depth-complexity", "lab/flattened", "lab/hierarchy",
    "lab/inside-shadow", "lab/cornell",      "lab/mirror-room",      "models/dice"};

TEST(HardwareAgreement, TrianglesAndColoursWithVerticesRoundedByTheProcessor) {
  PS_NEEDS_HARDWARE(hardware);
  for (const std::string& scene : agreement_scenes) {
    const PairDifference difference = measured({scene, {"vertex-snapping=cpu"}}, hardware);
    EXPECT_GT(difference.seen, difference.pixels / 20) << scene << ": hardly anything to compare";
    EXPECT_LE(difference.ids, most_ids) << scene;
    EXPECT_EQ(difference.colours, 0) << scene << ", by " << difference.largest;
  }
}

/// A driver interpolates from vertices that it has not rounded, so values are off by what they change within a
/// sub-pixel.
TEST(HardwareAgreement, TrianglesAndColoursWithVerticesRoundedByTheDriver) {
  PS_NEEDS_HARDWARE(hardware);
  for (const std::string& scene : agreement_scenes) {
    const PairDifference difference = measured({scene, {"vertex-snapping=driver"}}, hardware);
    EXPECT_LE(difference.ids, most_ids) << scene;
    EXPECT_LE(difference.colours, most_ids) << scene << ", by " << difference.largest;
  }
}

/// In these agreement_scenes each option acts on something.
const std::vector<std::string> option_scenes{"cgfs/shading", "cgfs/crates", "cgfs/fence", "cgfs/reflections"};

/// Settings, and options with all their values, that have a test of their own.
const std::map<std::string, std::string, std::less<>> compared_elsewhere{
    {"shadows=map", "see ShadowMapsExceptAtTheBordersOfTexels"},
    {"shadow-map-size", "see ShadowMapsExceptAtTheBordersOfTexels"},
    {"shadow-bias", "see ShadowMapsExceptAtTheBordersOfTexels"},
    {"shadow-slope-bias", "see ShadowMapsExceptAtTheBordersOfTexels"},
    {"shadow-filter", "see ShadowMapsExceptAtTheBordersOfTexels"},
    {"shadows=stencil-depth-fail", "see shadow_volumes_test.cpp"},
    {"shadows=stencil-depth-pass", "see shadow_volumes_test.cpp"},
    {"environment-size=16", "see TexelsOfEnvironmentMaps"},
    {"stencil-bits", "see shadow_volumes_test.cpp"},
    {"volume-caps", "see shadow_volumes_test.cpp"},
    {"volume-length", "see shadow_volumes_test.cpp"},
    {"volume-depth-clamp", "see shadow_volumes_test.cpp"},
    {"draw=wireframe", "see lines_test.cpp"},
    {"draw=points", "see lines_test.cpp"},
    {"hardware-texturing=driver", "see TheDriversOwnFilterIsCloseToTheFormula"},
    {"interpolation=affine", "see AffineInterpolationWhereNothingIsClipped"},
    {"depth-value=z", "see AffineInterpolationWhereNothingIsClipped"},
    {"texture-filter=nearest", "see NearestTexelsExceptAtTheirBorders"},
    {"anisotropy=16", "see AnisotropyWhereNoRatioIsAWholeNumber"},
};

std::vector<std::string> values_to_try(const Option& option) {
  std::vector<double> numbers;
  switch (option.kind) {
  case OptionKind::boolean:
    numbers = {0, 1};
    break;
  case OptionKind::choice:
    for (std::size_t i = 0; i < option.choices.size(); ++i) numbers.push_back(static_cast<double>(i));
    break;
  case OptionKind::integer:
  case OptionKind::real:
    numbers = {option.minimum, option.maximum};
    break;
  }
  if (option.key == "near") numbers = {0.01, 3.2};
  if (option.key == "far") numbers = {3.5, 1e30};
  if (option.key == "environment-size") numbers = {16, 300};
  if (option.key == "tessellation") numbers = {0.2, 20};
  if (option.key == "multisampling") numbers = {1, 2, 4, 8};
  if (option.key == "depth-bits") numbers = {10, 16, 24};
  std::vector<std::string> values;
  for (const double number : numbers) {
    Settings settings;
    option.set(settings, number);
    values.push_back(option_text(option, settings));
  }
  return values;
}

/// What an option needs in order to act.
std::vector<std::string> context_of(std::string_view key) {
  if (key == "depth-bits") return {"depth-format=unorm"};
  if (key == "depth-reversed") return {"depth-format=unit-float"};
  if (key == "environment-objects" || key == "environment-size") return {"environment=cube-map"};
  return {};
}

TEST(HardwareAgreement, EveryHonouredValueOfEveryOption) {
  PS_NEEDS_HARDWARE(hardware);
  std::set<std::string> compared;
  for (const Option& option : option_table()) {
    if (option.key == "renderer" || option.effect != OptionEffect::picture) continue;
    if (!acts_for(option.acts_for, PictureWay::fragments) || hardware::lacks_option(option, {})) continue;
    if (compared_elsewhere.contains(option.key)) continue;
    for (const std::string& value : values_to_try(option)) {
      Settings changed;
      parse_option(option, value, changed);
      const std::string setting = fmt::format("{}={}", option.key, value);
      if (hardware::lacks_value(option, option.get(changed), changed) || compared_elsewhere.contains(setting)) continue;
      for (const std::string& name : option_scenes) {
        std::vector<std::string> assignments = context_of(option.key);
        assignments.insert(assignments.end(), {"vertex-snapping=cpu", setting});
        const PairDifference difference = measured({name, assignments}, hardware, option_width, option_height);
        EXPECT_LE(difference.ids, most_option_ids) << name << " " << setting;
        EXPECT_LE(difference.colours, most_option_ids) << name << " " << setting << ", by " << difference.largest;
        compared.insert(setting);
      }
    }
  }
  EXPECT_GT(compared.size(), 60u);
}

/// A scene seen from `back` units further behind.
Scene seen_from_behind(const std::string& name, double back) {
  Scene scene = load_scene(name);
  scene.camera.position -= scene.camera.forward * back;
  return scene;
}

PairDifference measured(const Scene& scene, const std::vector<std::string>& assignments, Renderer hardware) {
  Settings settings =
      settings_with(settings_with(settings_for(scene), {"shadows=none", "reflection-depth=0"}), assignments);
  const PairDifference difference = test::compare_with_rasterizer(scene, settings, hardware, width, height);
  fmt::print("{} {}: {}\n", scene.name, fmt::join(assignments, " "), difference.text());
  return difference;
}

/// Triangles that cross the sides of the picture and the near plane: the rasterizer cuts them at the near plane alone.
TEST(HardwareAgreement, ClippingAtTheNearPlaneAlone) {
  PS_NEEDS_HARDWARE(hardware);
  for (const char* scene : {"cgpp/ground", "cgfs/behind", "lab/inside-shadow", "lab/cornell", "lab/mirror-room"}) {
    const PairDifference difference = measured({scene, {"clipping=near", "vertex-snapping=cpu"}}, hardware);
    EXPECT_GT(difference.seen, difference.pixels / 20) << scene;
    EXPECT_LE(difference.ids, most_ids) << scene;
    EXPECT_LE(difference.colours, most_ids) << scene << ", by " << difference.largest;
  }
  // Affine steps show where a triangle was cut: each piece has its own.
  EXPECT_LE(measured({"cgfs/crates", {"clipping=near", "interpolation=affine"}}, hardware).colours, most_ids);
  EXPECT_GT(measured({"cgfs/crates", {"clipping=full", "interpolation=affine"}}, hardware).colours, 5 * most_ids);
}

/// Of a triangle that is clipped, a driver interpolates across the whole in affine steps, and the rasterizer across
/// each piece. Seen from far enough away no triangle is clipped.
TEST(HardwareAgreement, AffineInterpolationWhereNothingIsClipped) {
  PS_NEEDS_HARDWARE(hardware);
  const Scene scene = seen_from_behind("cgfs/crates", 6);
  for (const char* setting : {"interpolation=affine", "depth-value=z"}) {
    const PairDifference difference = measured(scene, {"vertex-snapping=cpu", setting}, hardware);
    EXPECT_GT(difference.seen, difference.pixels / 20);
    EXPECT_LE(difference.ids, most_ids) << setting;
    EXPECT_LE(difference.colours, most_ids) << setting << ", by " << difference.largest;
  }
}

/// The number of lookups is rounded up, so where the sides of a footprint have a ratio of exactly 2, the last bit
/// decides between 2 and 3: on a wall that faces the camera, everywhere. A floor has no such place.
TEST(HardwareAgreement, AnisotropyWhereNoRatioIsAWholeNumber) {
  PS_NEEDS_HARDWARE(hardware);
  const PairDifference difference = measured({"cgfs/fence", {"vertex-snapping=cpu", "anisotropy=16"}}, hardware);
  EXPECT_LE(difference.ids, most_ids);
  EXPECT_LE(difference.colours, most_ids) << "by " << difference.largest;
}

/// A point that lies on the border of two texels of a map, or as far from the light as its texel says, is lit or not by
/// the last bit.
TEST(HardwareAgreement, ShadowMapsExceptAtTheBordersOfTexels) {
  PS_NEEDS_HARDWARE(hardware);
  const std::vector<std::vector<std::string>> variants{
      {},
      {"shadow-map-size=64"},
      {"shadow-filter=5"},
      {"shadow-filter=2"},
      {"shadow-bias=0.05", "shadow-slope-bias=0"},
      {"shadow-bias=0.01", "shadow-slope-bias=2"},
      {"light-passes=many"},
      {"projection=orthographic"},
      {"shading=gouraud"},
      {"shading=flat"},
      {"deferred-shading=on"},
  };
  for (const char* scene : {"cgfs/shadows", "lab/cornell", "octree/attenuation"}) {
    const PairDifference none = measured({scene, {"vertex-snapping=cpu"}}, hardware);
    for (const std::vector<std::string>& variant : variants) {
      std::vector<std::string> assignments{"vertex-snapping=cpu", "shadows=map"};
      assignments.insert(assignments.end(), variant.begin(), variant.end());
      const PairDifference difference = measured({scene, assignments}, hardware);
      EXPECT_LE(difference.ids, most_ids) << scene;
      EXPECT_LE(difference.colours, none.seen / 500) << scene;
    }
  }
}

/// A texel of a map covers many pixels, so in small maps it is texels that must agree, as pixels do in pictures. The
/// red sphere of cgfs/reflections is left out: its centre lies 0.0009 above a ground of radius 5000, and the driver's
/// vertices, floats from the ground's own centre on, are rounded by up to 0.00025.
TEST(HardwareAgreement, TexelsOfEnvironmentMaps) {
  PS_NEEDS_HARDWARE(hardware);
  for (const char* name : {"cgfs/mirrors", "lab/mirror-room", "models/dice"})
    for (const char* size : {"environment-size=16", "environment-size=128"}) {
      const Scene scene = load_scene(name);
      Settings settings =
          settings_with(settings_for(scene), {"vertex-snapping=cpu", "shadows=none", "environment=cube-map", size});
      settings.subpixel_bits = hardware::availability().driver->subpixel_bits;
      Prepared prepared;
      Progress progress;
      const auto expected = raster::environment_maps(scene, settings, prepared, WorkerPriority::normal, progress);
      settings.renderer = hardware;
      const hardware::PicturePlan plan = hardware::make_plan(scene, {scene.camera, 40, 30}, settings, {}, prepared);
      const auto drawn = hardware::draw_environment(plan, prepared, WorkerPriority::normal, progress);
      long texels = 0, different = 0;
      for (std::size_t i = 0; i < expected->size(); ++i) {
        ASSERT_EQ((*expected)[i] == nullptr, (*drawn)[i] == nullptr);
        if (!(*expected)[i]) continue;
        for (std::size_t face = 0; face < 6; ++face)
          for (std::size_t t = 0; t < (*expected)[i]->faces[face].pixels().size(); ++t) {
            const Vec3f change = (*expected)[i]->faces[face].pixels()[t] - (*drawn)[i]->faces[face].pixels()[t];
            ++texels;
            different += std::max({std::abs(change.x), std::abs(change.y), std::abs(change.z)}) > 1.0f / 255;
          }
      }
      fmt::print("{} {}: {} of {} texels differ\n", name, size, different, texels);
      EXPECT_GT(texels, 0);
      EXPECT_LE(different, 1 + texels * most_ids / (width * height)) << name << " " << size;
    }
}

/// What the passes share, in pairs: buffers of deferred shading, environment maps, shadows and light computed at
/// vertices.
TEST(HardwareAgreement, PassesTogether) {
  PS_NEEDS_HARDWARE(hardware);
  const std::vector<std::vector<std::string>> variants{
      {"deferred-shading=on", "shading=gouraud"},
      {"deferred-shading=on", "shading=flat"},
      {"deferred-shading=on", "lighting=off"},
      {"deferred-shading=on", "depth-value=distance"},
      {"environment=cube-map", "deferred-shading=on"},
      {"environment=cube-map", "light-passes=many"},
      {"environment=cube-map", "shading=gouraud"},
      {"environment=cube-map", "shadows=stencil-depth-fail"},
      {"environment=cube-map", "shadows=stencil-depth-fail", "deferred-shading=on"},
      {"environment=room-map", "shading=flat"},
      {"environment=room-map", "early-depth=on"},
  };
  for (const char* name : {"cgfs/reflections", "lab/mirror-room", "models/dice"})
    for (const std::vector<std::string>& variant : variants) {
      std::vector<std::string> assignments{"vertex-snapping=cpu", "shadows=none"};
      assignments.insert(assignments.end(), variant.begin(), variant.end());
      const PairCase one{name, assignments};
      const PairDifference difference = compare_with_rasterizer(one, hardware, option_width, option_height);
      fmt::print("{}: {}\n", one.name(), difference.text());
      EXPECT_LE(difference.ids, most_option_ids) << one.name();
      EXPECT_LE(difference.colours, most_option_ids) << one.name() << ", by " << difference.largest;
    }
}

/// The maps are drawn by the driver, and they shade: without them many pixels are brighter.
TEST(HardwareAgreement, ShadowMapsDarken) {
  PS_NEEDS_HARDWARE(hardware);
  const Scene scene = load_scene("cgfs/shadows");
  Settings settings = settings_for(scene, hardware);
  settings.shadows = Shadows::map;
  const View view{scene.camera, 300, 300};
  const Image<Vec3f> dark = render(scene, view, settings).colour;
  settings.shadows = Shadows::none;
  const Image<Vec3f> bright = render(scene, view, settings).colour;
  long darker = 0;
  for (std::size_t i = 0; i < dark.pixels().size(); ++i) darker += dark.pixels()[i].x < bright.pixels()[i].x - 0.01f;
  EXPECT_GT(darker, 1000);
}

/// Where a sample lies on the border between two texels, the last bit of its texture coordinate decides.
TEST(HardwareAgreement, NearestTexelsExceptAtTheirBorders) {
  PS_NEEDS_HARDWARE(hardware);
  for (const char* scene : {"cgfs/fence", "cgfs/crates"}) {
    const PairDifference difference = measured({scene, {"vertex-snapping=cpu", "texture-filter=nearest"}}, hardware);
    EXPECT_LE(difference.ids, most_ids) << scene;
    EXPECT_LE(difference.colours, difference.seen / 1000) << scene;
  }
}

/// How far a driver's filter strays from the formula differs from driver to driver; it must be a filter of the same
/// texture.
TEST(HardwareAgreement, TheDriversOwnFilterIsCloseToTheFormula) {
  PS_NEEDS_HARDWARE(hardware);
  for (const char* filter : {"nearest", "bilinear", "mipmap", "trilinear"}) {
    const PairDifference difference = measured(
        {"cgfs/crates", {"vertex-snapping=cpu", "hardware-texturing=driver", std::string("texture-filter=") + filter}},
        hardware);
    EXPECT_LE(difference.ids, most_ids) << filter;
    EXPECT_LE(difference.colours, difference.seen / 10) << filter << ", by " << difference.largest;
  }
}

}  // namespace
}  // namespace ps
