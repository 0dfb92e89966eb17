// In the real window: every scene that Pixelscope ships with opens and shows pictures of its own.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "gui/program.h"
#include "scene/load.h"
#include "support/golden.h"

namespace every_scene_test {
namespace {

class EveryScene : public testing::TestWithParam<const char*> {};

TEST_P(EveryScene, Opens) {
  std::string script;
  for (const auto& scene : ps::builtin_scenes())
    script += fmt::format(
        "keep a/picture BEFORE\nopen {0}\nwait idle\nexpect scene {0}\nexpect a/state done\nexpect b/state done\n"
        "expect messages 0\nexpect a/events > 0\nexpect b/events > 0\nexpect-not a/picture $BEFORE\n",
        scene.name);
  // Begins with a scene that is not the first of the list.
  const auto folder = ps::fresh_output_folder("gui-every-scene");
  const auto result = ps::test::play("wait idle\n" + script + "quit\n", folder, GetParam(), "cgfs/reflections");
  EXPECT_EQ(result.status, 0) << result.errors;
  EXPECT_EQ(result.errors, "");
}

INSTANTIATE_TEST_SUITE_P(Window, EveryScene, testing::Values("1024x768"));

}  // namespace
}  // namespace every_scene_test
