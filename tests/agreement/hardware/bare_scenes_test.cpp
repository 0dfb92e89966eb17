// Scenes without casters, lights and objects, in pictures of one pixel, one row and one column, by the hardware
// renderer: each value of each option that it reads, in one of these. The rasterizer shows the same.
#include <gtest/gtest.h>

#include <array>
#include <numeric>
#include <vector>

#include "agreement/hardware/hardware_pair.h"
#include "base/enumerators.h"
#include "hardware/lacks.h"
#include "options/option.h"
#include "options/renderer_kind.h"
#include "options/scene_settings.h"
#include "render/render.h"
#include "scene/load.h"
#include "support/bare_scene.h"

namespace ps::hardware_bare_scenes_test {
namespace {

struct BareCase {
  std::string name;
  Scene scene;
  Vec2i size;
};

std::vector<BareCase> all_cases() {
  std::vector<BareCase> cases;
  for (const char* scene : {"cgfs/relief", "cgfs/shadows"})
    for (const test::Bare what : all_enumerators<test::Bare>)
      for (const Vec2i size : {Vec2i{1, 1}, Vec2i{600, 1}, Vec2i{1, 600}})
        cases.push_back({std::string(scene) + " " + std::string(enumerator_key(what)),
                         test::bare_scene(load_scene(scene), what), size});
  return cases;
}

/// The choices, or the ends of the range, that the renderer acts on.
std::vector<OptionNumber> values_to_try(const Option& option, const Settings& settings) {
  const bool read = acts_for(option.acts_for, PictureWay::fragments) || option.acts_for == ActsFor::readers;
  if (!read || option.key == "renderer" || hardware::lacks_option(option, settings)) return {};
  std::vector<OptionNumber> values{option.minimum, option.maximum};
  for (const std::string_view large : {"shadow-map-size", "environment-size"})
    if (option.key == large) values.pop_back();
  if (option.kind == OptionKind::boolean) values = {0, 1};
  if (option.kind == OptionKind::choice) {
    values.resize(option.choices.size());
    std::iota(values.begin(), values.end(), OptionNumber(0));
  }
  std::erase_if(values, [&](OptionNumber value) { return hardware::lacks_value(option, value, settings).has_value(); });
  return values;
}

TEST(HardwareBareScenes, AreDrawnUnderEveryOption) {
  PS_NEEDS_HARDWARE(hardware);
  const std::vector<BareCase> cases = all_cases();
  std::size_t pictures = 0;
  for (const Option& option : option_table()) {
    Settings settings{.renderer = hardware};
    for (const OptionNumber value : values_to_try(option, settings)) {
      const BareCase& one = cases[7 * pictures % cases.size()];  // 7 has no factor in common with their number
      settings = settings_for(one.scene);
      settings.shadow_map_size = settings.environment_size = 8;
      settings.shadows = Shadows::map;
      option.set(settings, value);
      SCOPED_TRACE(one.name + ", " + std::string(option.key) + "=" + option_text(option, settings));
      const test::PairDifference difference =
          test::compare_with_rasterizer(one.scene, settings, hardware, one.size.x, one.size.y);
      // A driver's lines and points lie up to a pixel beside ours (lines_test.cpp): of a single row, perhaps outside.
      if (fills(settings.draw)) {
        EXPECT_LE(difference.ids, difference.pixels / 50) << difference.text();
      }
      EXPECT_LE(difference.colours, difference.pixels / 50) << difference.text();
      ++pictures;
    }
  }
  EXPECT_GT(pictures, 60u);
}

}  // namespace
}  // namespace ps::hardware_bare_scenes_test
