// What is said of a hardware picture that leaves something out is true: each remedy that is offered shows it.
#include <gtest/gtest.h>

#include <algorithm>

#include "agreement/hardware/hardware_pair.h"
#include "options/option.h"
#include "options/scene_settings.h"
#include "render/left_out.h"
#include "render/render.h"
#include "scene/load.h"
#include "support/settings_with.h"

namespace ps::hardware_left_out_test {
namespace {

bool says(const std::vector<LeftOut>& all, const std::string& brief) {
  return std::any_of(all.begin(), all.end(), [&](const LeftOut& one) { return brief_text(one.brief) == brief; });
}

TEST(HardwareLeftOut, EveryRemedyShowsWhatIsLeftOut) {
  PS_NEEDS_HARDWARE(hardware);
  int own = 0;
  for (const char* name : {"cgfs/shadows", "cgfs/reflections"}) {
    const Scene scene = load_scene(name);
    const SceneTraits traits = scene_traits(scene);
    Settings settings = settings_for(scene, hardware);
    settings.shadows = Shadows::traced;
    const std::vector<LeftOut> all = left_out(traits, settings);
    EXPECT_FALSE(all.empty()) << name;
    for (const LeftOut& one : all) {
      EXPECT_FALSE(one.remedies.empty()) << one.sentence;
      for (const Remedy& remedy : one.remedies) {
        Settings mended = settings;
        parse_assignment(remedy.setting, mended);
        EXPECT_FALSE(says(left_out(traits, mended), brief_text(one.brief))) << name << ": " << remedy.setting;
        if (mended.renderer != hardware) continue;
        ++own;
        const View view{scene.camera, 60, 60};
        const Frame before = render(scene, view, settings);
        const Frame after = render(scene, view, mended);
        EXPECT_FALSE(std::ranges::equal(before.colour.pixels(), after.colour.pixels()))
            << name << ": " << remedy.setting;
      }
    }
  }
  EXPECT_GE(own, 3);  // shadow maps, stencil shadows, cube maps
}

}  // namespace
}  // namespace ps::hardware_left_out_test
