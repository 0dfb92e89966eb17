// Every built-in scene with all objects transparent, without lights and without objects, under every value of every
// option: a picture of some pixels and the story of one of them. No light has a caster then, no list an element.
#include <gtest/gtest.h>

#include "base/check.h"
#include "options/option.h"
#include "options/scene_settings.h"
#include "render/render.h"
#include "scene/load.h"
#include "support/bare_scene.h"
#include "support/trials.h"

namespace ps::bare_scenes_test {
namespace {

/// The scenes are shared out to so many tests, which run beside each other.
constexpr int parts = 8;

/// All choices; the ends of a range, but for the largest values that cost a second and change no code path.
std::vector<OptionNumber> values_to_try(const Option& option) {
  std::vector<OptionNumber> values;
  switch (option.kind) {
  case OptionKind::boolean:
    return {0, 1};
  case OptionKind::choice:
    for (std::size_t i = 0; i < option.choices.size(); ++i) values.push_back(static_cast<OptionNumber>(i));
    return values;
  case OptionKind::integer:
  case OptionKind::real:
    break;
  }
  for (const std::string_view large : {"samples-per-pixel", "shadow-map-size", "environment-size", "threads"})
    if (option.key == large) return {option.minimum};
  return {option.minimum, option.maximum};
}

/// What is always small.
void keep_small(Settings& settings) {
  settings.threads = 1;
  settings.shadow_map_size = settings.environment_size = 8;
}

class BareScenes : public testing::TestWithParam<int> {};

TEST_P(BareScenes, AreDrawnAndToldUnderEveryOption) {
  const std::vector<BuiltinScene>& scenes = builtin_scenes();
  int pictures = 0;
  for (auto i = static_cast<std::size_t>(GetParam()); i < scenes.size(); i += parts * test::list_step)
    for (const test::Bare what : test::all_bare) {
      const Scene scene = test::bare_scene(load_scene(scenes[i].name), what);
      const SceneTraits traits = scene_traits(scene);
      const View view{scene.camera, 5, 4};
      Prepared prepared;
      for (const Renderer renderer : {Renderer::ray_tracer, Renderer::rasterizer})
        for (const Option& option : option_table()) {
          Settings settings = settings_for(scene);
          keep_small(settings);
          settings.renderer = renderer;
          if (inactive_reason(option, settings, traits)) continue;
          for (const OptionNumber value : values_to_try(option)) {
            option.set(settings, value);
            SCOPED_TRACE(std::string(option.key) + "=" + option_text(option, settings) + ", " + scene.name + " " +
                         std::string(bare_name(what)));
            Progress progress;
            RenderRequest request;
            request.channels = Channel::ids | Channel::stencil | Channel::shadow;
            ASSERT_NO_THROW(render(scene, view, settings, request, prepared, progress));
            ASSERT_NO_THROW(inspect(scene, view, settings, {2, 2}, prepared, progress));
            ++pictures;
          }
        }
    }
  EXPECT_GT(pictures, 1000);
}

INSTANTIATE_TEST_SUITE_P(Part, BareScenes, testing::Range(0, parts));

}  // namespace
}  // namespace ps::bare_scenes_test
