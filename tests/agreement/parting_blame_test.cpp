// Where the stories of two renderers part, the sentence blames no option that one of them does not use: neither by its
// values in both pictures, nor at all where only the side that does not use it has another value than the default.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "frame/display_frame.h"
#include "inspect/parting/parting.h"
#include "options/option.h"
#include "options/scene_settings.h"
#include "render/render.h"
#include "scene/load.h"
#include "support/environment.h"
#include "support/random_settings.h"

namespace ps::parting_blame_test {
namespace {

constexpr int side = 120;

struct Sides {
  Scene scene;
  View view;
  Settings a, b;
  Prepared prepared;
  Progress progress;

  explicit Sides(const char* name)
      : scene(load_scene(name)), view{scene.camera, side, side}, a(settings_for(scene)), b(a) {
    a.renderer = Renderer::ray_tracer;
    b.renderer = Renderer::rasterizer;
  }
  std::string sentence(Vec2i pixel) {
    const PixelStory of_a = inspect(scene, view, a, pixel, prepared, progress);
    const PixelStory of_b = inspect(scene, view, b, pixel, prepared, progress);
    return find_parting(scene, {of_a, a}, {of_b, b}).sentence;
  }
};

bool acts(const Option& option, const Settings& settings, const SceneTraits& traits) {
  return !inactive_reason(option, settings, traits) && !inactive_value_reason(option, settings, traits);
}

/// "self-hit is " where it is not the end of another key: "reflection-depth is " holds no "depth is ".
bool names(const std::string& sentence, std::string_view key) {
  const std::size_t at = sentence.find(fmt::format("{} is ", key));
  return at != std::string::npos && (at == 0 || sentence[at - 1] == ' ');
}

TEST(PartingBlame, NamesNoOptionThatASideDoesNotUse) {
  const unsigned seed = test::test_seed();
  std::mt19937 random(seed);
  int looked_at = 0;
  for (const char* name : {"cgfs/reflections", "cgfs/crates", "cgfs/shading"}) {
    const SceneTraits traits = scene_traits(load_scene(name));
    for (const Option& option : option_table()) {
      if (option.effect != OptionEffect::picture || option.group == "Renderer") continue;
      for (const bool in_a : {true, false}) {
        Sides sides(name);
        Settings& changed = in_a ? sides.a : sides.b;
        option.set(changed, test::random_value(option, random));
        const bool acts_a = acts(option, sides.a, traits), acts_b = acts(option, sides.b, traits);
        if (option.get(sides.a) == option.get(sides.b) || (acts_a && acts_b)) continue;
        for (int i = 0; i < 4; ++i) {
          const std::string said = sides.sentence({test::below(random, side), test::below(random, side)});
          const std::string words = fmt::format("seed {}, {}, {} in {}: {}", seed, name, option.key,
                                                in_a ? "the ray tracer" : "the rasterizer", said);
          ++looked_at;
          const bool acts_where_changed = in_a ? acts_a : acts_b;
          const bool one_sided = said.find("does not use it") != std::string::npos;
          // Not what differs, but why one side has none: its own value, whatever the other side has.
          const bool why_none = said.find("only one of the two renderers computes shadows") != std::string::npos;
          EXPECT_TRUE(!names(said, option.key) || (acts_where_changed && one_sided) || why_none) << words;
        }
      }
    }
  }
  EXPECT_GT(looked_at, 200) << "seed " << seed;
}

// The rasterizer follows no mirrored ray, however many bounces either side may have.
TEST(PartingBlame, TheRendererBeforeTheDepthOfReflections) {
  for (const auto& [in_a, in_b] : {std::pair{2, 3}, {3, 2}, {3, 0}}) {
    Sides sides("cgfs/reflections");
    sides.view = {sides.scene.camera, 600, 600};
    sides.a.reflection_depth = in_a;
    sides.b.reflection_depth = in_b;
    const std::string said = sides.sentence({300, 420});
    EXPECT_NE(said.find("renderer is ray-tracer in A and rasterizer in B"), std::string::npos) << said;
  }
}

// Where only the last digits differ: an epsilon of rays is none of the rasterizer's, and passes are none of the ray's.
TEST(PartingBlame, TheRendererBeforeTheLastDigits) {
  int digits = 0;
  for (const char* name : {"cgfs/reflections", "cgfs/shadows", "cgfs/shading"}) {
    Sides sides(name);
    sides.a.self_hit = SelfHit::epsilon;
    sides.a.shadows = sides.b.shadows = Shadows::none;
    sides.a.reflection_depth = 0;
    for (int y = 2; y < side; y += 5)
      for (int x = 2; x < side; x += 5) {
        const PixelStory of_a = inspect(sides.scene, sides.view, sides.a, {x, y}, sides.prepared, sides.progress);
        const PixelStory of_b = inspect(sides.scene, sides.view, sides.b, {x, y}, sides.prepared, sides.progress);
        const Parting parting = find_parting(sides.scene, {of_a, sides.a}, {of_b, sides.b});
        if (parting.cause != PartingCause::precision) continue;
        ++digits;
        EXPECT_EQ(parting.sentence.find("self-hit"), std::string::npos) << parting.sentence;
        EXPECT_EQ(parting.sentence.find("pass"), std::string::npos) << parting.sentence;
        EXPECT_NE(parting.sentence.find("renderer is ray-tracer in A and rasterizer in B"), std::string::npos)
            << parting.sentence;
      }
  }
  EXPECT_GT(digits, 20);
}

}  // namespace
}  // namespace ps::parting_blame_test
