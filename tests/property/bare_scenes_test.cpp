// Every built-in scene with all objects transparent, without lights and without objects, under every value of every
// option: a picture of some pixels and the story of one of them. No light has a caster then, no list an element. The
// scenes of tests/corpus are drawn as they are.
#include <gtest/gtest.h>

#include <filesystem>
#include <optional>

#include "base/check.h"
#include "base/enumerators.h"
#include "options/option.h"
#include "options/scene_settings.h"
#include "scene/load.h"
#include "support/bare_scene.h"
#include "support/option_contexts.h"
#include "support/render_once.h"
#include "support/trials.h"

namespace ps::bare_scenes_test {
namespace {

/// The scenes are shared out to so many tests, which run beside each other.
constexpr int parts = 16;

/// All choices; the ends of a range, but for the largest values that cost a second and change no code path.
std::vector<OptionNumber> values_to_try(const Option& option) {
  for (const std::string_view large : {"samples-per-pixel", "shadow-map-size", "environment-size", "threads"})
    if (option.key == large) return {option.minimum};
  return test::values_of(option);
}

/// What is always small.
void keep_small(Settings& settings) {
  settings.threads = 1;
  settings.shadow_map_size = settings.environment_size = 8;
}

/// Gives the number of pictures.
int draw_under_every_option(const Scene& scene, const std::string& name) {
  int pictures = 0;
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
        SCOPED_TRACE(name + ", " + std::string(option.key) + "=" + option_text(option, settings));
        Progress progress;
        EXPECT_NO_THROW(render(scene, view, settings, request_for(Channel::ids | Channel::stencil | Channel::shadow),
                               prepared, progress));
        EXPECT_NO_THROW(inspect(scene, view, settings, {2, 2}, prepared, progress));
        ++pictures;
      }
    }
  return pictures;
}

class BareScenes : public testing::TestWithParam<int> {};

TEST_P(BareScenes, AreDrawnAndToldUnderEveryOption) {
  const std::vector<BuiltinScene>& scenes = builtin_scenes();
  int pictures = 0;
  for (auto i = static_cast<std::size_t>(GetParam()); i < scenes.size(); i += parts * test::list_step)
    for (const test::Bare what : all_enumerators<test::Bare>) {
      const Scene scene = test::bare_scene(load_scene(scenes[i].name), what);
      pictures += draw_under_every_option(scene, scenes[i].name + " " + std::string(enumerator_key(what)));
    }
  EXPECT_GT(pictures, 200);
}

INSTANTIATE_TEST_SUITE_P(Part, BareScenes, testing::Range(0, parts));

TEST(KeptScenes, AreDrawnAndToldUnderEveryOption) {
  int scenes = 0;
  for (const auto& file : std::filesystem::directory_iterator("tests/corpus/scene")) {
    std::optional<Scene> scene;
    try {
      scene = load_scene(file.path().string());
      settings_for(*scene);
    } catch (const InputError&) {
      continue;  // kept since it is refused
    }
    draw_under_every_option(*scene, file.path().string());
    ++scenes;
  }
  EXPECT_GT(scenes, 5);
}

}  // namespace
}  // namespace ps::bare_scenes_test
