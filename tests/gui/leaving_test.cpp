// How the window ends and fails: a graphics driver that takes long keeps nobody; what is not saved is said.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "gui/program.h"
#include "gui/remembering_window.h"
#include "support/golden.h"
#include "support/option_contexts.h"
#include "support/run_cli.h"
#include "support/slow_shaders.h"

namespace ps::gui::leaving_test {
namespace {

TEST(Leaving, ADriverThatShowsNothingIsTakenWhereItIsNamed) {
  const test::ScratchFolder folder;
  const std::string script = folder.write("s.script", "wait idle\nprint window/size\nquit\n");
  const auto named = test::run_window("cgfs/spheres --size 64x64 --script " + script,
                                      "timeout 60 env -u DISPLAY SDL_VIDEODRIVER=offscreen");
  EXPECT_EQ(named.status, 0) << named.errors;
}

TEST(Leaving, DoesNotWaitForADriver) {
  if (!test::has_renderer("hardware")) GTEST_SKIP() << "this build has no hardware renderer";
  const auto folder = std::filesystem::absolute(fresh_output_folder("gui-leaving"));
  const test::SlowShaders shaders;
  const test::ScratchFolder scratch;
  const std::string script =
      scratch.write("s.script", "wait idle\nset renderer=hardware\nwait 1500\nset shading=flat\nwait frames 3\nquit\n");
  const auto result = test::run_window("cgfs/shading --size 64x64 --script " + script,
                                       "timeout 40 env XDG_STATE_HOME=" + folder.string());
  EXPECT_EQ(result.status, 0) << result.errors;
  int sessions = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "pixelscope"))
    sessions += entry.path().filename().string().starts_with("open-");
  EXPECT_EQ(sessions, 0) << "it would be taken for one that crashed";
  EXPECT_TRUE(std::filesystem::exists(folder / "pixelscope/window.json"));
}

// A file in the folder's place fails as a full disk does, also for root.
TEST(Leaving, WhatIsNotSavedIsSaidAndTriedAgain) {
  const auto folder = std::filesystem::absolute(fresh_output_folder("gui-unsaved"));
  const std::filesystem::path place = folder / "pixelscope";
  std::ofstream(place) << "in the way";
  const auto result = test::play_by_hand("wait until message contains \"not saved any more\"\nprint window/size\n"
                                         "wait until message contains \"saved again\"\nquit\n",
                                         "rm " + place.string() + "\n", folder, test::small_scene,
                                         "env XDG_STATE_HOME=" + folder.string());
  EXPECT_EQ(result.status, 0) << result.errors;
  EXPECT_EQ(result.errors, "");
}

TEST(Leaving, ALongValueLeavesRoomForTheWindow) {
  const test::Home home("long-value");
  std::string value;
  for (int i = 0; i < 5000; ++i) value += "a\tb\n";
  home.remember("window/scale", value);
  home.plays("expect message/0/text contains window/scale\nprint message/0/dismiss@middle\n"
             "click message/0/dismiss\nwait idle\nquit\n");
}

}  // namespace
}  // namespace ps::gui::leaving_test
