// Size and state of the window from one start to the next, full screen and back, and no work while nobody sees it; with
// a window manager and without one. The tests' display has 1920x1200 pixels.
#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <sstream>
#include <string>

#include "gui/platform/normal_size.h"
#include "gui/program.h"
#include "gui/remembering_window.h"
#include "support/golden.h"

namespace ps::gui::window_placement_test {
namespace {

using namespace std::chrono_literals;
using test::geometry_into;
using test::Home;
using test::small_scene;

TEST(NormalSize, IsNeverASizeOfAnotherState) {
  const NormalSize::Time start{};
  const WindowSize usual{1000, 700}, display{1920, 1200}, dragged{900, 600};
  // The size comes before the state, and the state before the size.
  for (const bool size_first : {true, false}) {
    NormalSize normal(usual);
    normal.take(usual, true, start);
    if (size_first) normal.take(display, true, start + 10s);
    if (!size_first) normal.take(usual, false, start + 10s);
    normal.take(display, false, start + 10s + 20ms);
    normal.take(display, false, start + 60s);
    EXPECT_EQ(normal.get(), usual) << size_first;
    // Back: again either way.
    if (size_first) normal.take(usual, false, start + 70s);
    if (!size_first) normal.take(display, true, start + 70s);
    normal.take(usual, true, start + 70s + 20ms);
    normal.take(dragged, true, start + 80s);
    normal.take(dragged, false, start + 90s);
    EXPECT_EQ(normal.get(), dragged) << size_first;
  }
}

TEST(WindowPlacement, OpensAtNineTenthsOfTheDisplayAtFirstAndThenAsItWasLeft) {
  const Home home("first");
  home.plays("expect window/size 1728x1080\nexpect window/maximised off\nresize 1000x700\nwait idle\n");
  EXPECT_EQ(home.remembered("window/size"), "1000x700");
  EXPECT_EQ(home.remembered("window/maximised"), "no");
  home.plays("expect window/size 1000x700\n");
}

TEST(WindowPlacement, IsNeverLargerThanTheDisplay) {
  const Home home("clamped");
  home.remember("window/size", "4000x900");
  home.plays("expect window/size 1920x900\nresize 1000x5000\nwait idle\nexpect window/size 1000x1200\n");
  const auto result = test::play_by_hand("wait idle\nexpect window/size 1920x1200\n", {}, home.folder,
                                         std::string(small_scene) + " --window-size 5000x4000");
  EXPECT_EQ(result.status, 0) << result.errors;
}

// Nobody is there to maximise it, so it covers the display by itself, and is left as it was.
TEST(WindowPlacement, MaximisedWithoutAWindowManager) {
  const Home home("covers");
  home.remember("window/size", "1000x700");
  home.remember("window/maximised", "yes");
  home.plays("expect window/size 1920x1200\nexpect window/maximised on\nkey F11\nwait idle\nkey F11\nwait idle\n"
             "expect window/size 1920x1200\nexpect window/maximised on\n");
  EXPECT_EQ(home.remembered("window/size"), "1000x700");
  EXPECT_EQ(home.remembered("window/maximised"), "yes");
}

// A script that wants a larger window brings a larger display.
TEST(WindowPlacement, TheVirtualDisplayIsAsLargeAsTheWindow) {
  const auto folder = fresh_output_folder("gui-placement-large");
  const auto large = test::play("wait idle\nexpect window/size 3840x2160\n", folder, "3840x2160", small_scene);
  EXPECT_EQ(large.status, 0) << large.errors;
  std::ofstream(folder / "grows.script") << "wait idle\nresize 2560x1440\nwait idle\nexpect window/size 2560x1440\n";
  const auto grows = test::run_window(std::string(small_scene) + " --script " + (folder / "grows.script").string(),
                                      "app/virtual-display");
  EXPECT_EQ(grows.status, 0) << grows.errors;
}

TEST(WindowPlacement, FullScreenWithoutAWindowManager) {
  if (!test::have_xdotool()) GTEST_SKIP() << "xdotool is not installed";
  const Home home("no-manager");
  const auto seen = home.folder / "seen";
  // Laid out for the whole display: the menu at the left, the status line at its lower edge.
  home.plays("resize 1000x700\nwait idle\nprint window/size\nwait until window/fullscreen on\nwait idle\n"
             "expect window/size 1920x1200\nscreenshot " +
                 (home.folder / "full.png").string() +
                 "\n"
                 "wait until window/fullscreen off\nwait idle\nexpect window/size 1000x700\nwait 2000\n",
             geometry_into(seen) + "xdotool windowfocus $window key F11\n" + test::wait_for_width(1920) + "sleep 1\n" +
                 geometry_into(seen) + "xdotool key F11\n" + test::wait_for_width(1000) + "sleep 0.3\n" +
                 geometry_into(seen));
  std::istringstream words(test::read_file(seen));
  std::string before, whole, after;
  for (std::string* text : {&before, &whole, &after})
    for (std::string word; *text += *text == "" ? "" : " ", words >> word;) {
      *text += word;
      if (word.starts_with("HEIGHT=")) break;
    }
  EXPECT_EQ(whole, "X=0 Y=0 WIDTH=1920 HEIGHT=1200");
  EXPECT_EQ(after, before);
  EXPECT_NE(before.find("WIDTH=1000 HEIGHT=700"), std::string::npos) << before;
  EXPECT_EQ(home.remembered("window/size"), "1000x700");
}

TEST(WindowPlacement, TheSizeOfAFullScreenIsNotRemembered) {
  const Home home("left-full");
  home.plays(
      "resize 1000x700\nwait 700\nkey F11\nwait idle\nexpect window/fullscreen on\nexpect window/size 1920x1200\n");
  EXPECT_EQ(home.remembered("window/size"), "1000x700");
  home.plays("expect window/fullscreen off\nexpect window/size 1000x700\n");
}

}  // namespace
}  // namespace ps::gui::window_placement_test
