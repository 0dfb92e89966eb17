// The window under a window manager: full screen and maximised, from one start to the next, and no work while nobody
// sees it. The tests' display has 1920x1200 pixels.
#include <gtest/gtest.h>

#include <cstdio>
#include <sstream>
#include <string>

#include "gui/program.h"
#include "gui/remembering_window.h"
#include "gui/window_manager.h"

namespace ps::test::window_manager_test {
namespace {

TEST(WindowManager, FullScreenWithAWindowManagerGivesBackEveryState) {
  if (!WindowManager::available()) GTEST_SKIP() << "openbox or xdotool is not installed";
  const WindowManager manager;
  ASSERT_TRUE(manager.runs());
  const Home home("manager");
  home.plays("resize 1000x700\nwait 700\nkey F11\nwait until window/size 1920x1200\nexpect window/fullscreen on\n"
             "key F11\nwait until window/size 1000x700\nexpect window/fullscreen off\n"
             "print window/size\nwait until window/maximised on\nwait 700\nwait idle\nkeep window/size MAXIMISED\n"
             "expect-not window/size 1000x700\n"
             "key F11\nwait until window/size 1920x1200\nexpect window/maximised on\nwait 700\n"
             "key F11\nwait until window/size $MAXIMISED\nwait 1500\nexpect window/size $MAXIMISED\n"
             "expect window/maximised on\nexpect window/fullscreen off\n",
             "xdotool key alt+m\n");
  EXPECT_EQ(home.remembered("window/size"), "1000x700");
  EXPECT_EQ(home.remembered("window/maximised"), "yes");
  // The next start is maximised, and has a normal size to go back to.
  home.plays("wait until window/maximised on\nwait idle\nexpect-not window/size 1000x700\nprint window/size\n"
             "wait until window/maximised off\nwait until window/size 1000x700\n",
             "xdotool key alt+m\n");
  EXPECT_EQ(home.remembered("window/size"), "1000x700");
  EXPECT_EQ(home.remembered("window/maximised"), "no");
}

TEST(WindowManager, LeftInFullScreenAndMaximisedBothAreRememberedApart) {
  if (!WindowManager::available()) GTEST_SKIP() << "openbox or xdotool is not installed";
  const WindowManager manager;
  ASSERT_TRUE(manager.runs());
  const Home home("manager-left-full");
  home.plays("resize 1000x700\nwait 700\nprint window/size\nwait until window/maximised on\nwait 700\nkey F11\n"
             "wait until window/size 1920x1200\nwait 700\n",
             "xdotool key alt+m\n");
  EXPECT_EQ(home.remembered("window/size"), "1000x700");
  EXPECT_EQ(home.remembered("window/maximised"), "yes");
}

TEST(WindowManager, AWindowWithATitleBarFitsIntoTheDisplay) {
  if (!WindowManager::available()) GTEST_SKIP() << "openbox or xdotool is not installed";
  const WindowManager manager;
  ASSERT_TRUE(manager.runs());
  const Home home("decorated");
  home.remember("window/size", "1920x1200");
  home.plays("wait 1500\nprint window/place\nprint window/size\n");
  int x = -1, y = -1, width = 0, height = 0;
  ASSERT_EQ(std::sscanf(home.output.c_str(), "%d,%d %dx%d", &x, &y, &width, &height), 4) << home.output;
  EXPECT_GT(y, 0) << "its title is above";
  EXPECT_LE(y + height, 1200) << home.output;
  EXPECT_LE(x + width, 1920) << home.output;
  EXPECT_GT(height, 1100);
}

// A window manager takes Alt and a drag for itself, but not a plain drag.
TEST(WindowManager, APlainDragCarriesTheCameraAround) {
  if (!WindowManager::available()) GTEST_SKIP() << "openbox or xdotool is not installed";
  const WindowManager manager;
  ASSERT_TRUE(manager.runs());
  const Home home("orbit");
  home.plays("resize 1366x768\nwait idle\nexpect camera/position/x 0\nprint view/a/orbit@middle\n"
             "wait until undo orbit\nwait idle\nexpect-not camera/position/x 0\nexpect camera/forward/y 0\n",
             "xdotool mousemove --window $window ${line%,*} ${line#*,}\nsleep 0.3\nxdotool mousedown 1\n"
             "for i in $(seq 20); do xdotool mousemove_relative 3 0; sleep 0.02; done\nxdotool mouseup 1\n");
}

/// Turns of the loop, frames laid out and frames drawn within three seconds.
struct Activity {
  int turns = 0, frames = 0, drawn = 0;
};
Activity activity(const std::string& output) {
  std::istringstream lines(output.substr(output.find('\n') + 1));
  Activity before, after;
  lines >> before.turns >> before.frames >> before.drawn >> after.turns >> after.frames >> after.drawn;
  EXPECT_FALSE(lines.fail()) << output;
  return {after.turns - before.turns, after.frames - before.frames, after.drawn - before.drawn};
}

// Minimised, or on a desktop that is not shown: also while the camera flies, and with keys and movements that wait for
// their frame.
TEST(WindowManager, DoesNothingWhileNobodySeesIt) {
  if (!WindowManager::available()) GTEST_SKIP() << "openbox or xdotool is not installed";
  const WindowManager manager;
  ASSERT_TRUE(manager.runs());
  const std::string counts = "print window/turns\nprint window/frames\nprint window/frames-drawn\n";
  // A key that comes before the window manager has given the window the keyboard is lost.
  const std::string until_hidden = "; sleep 0.2; xdotool search --onlyvisible --name '^Pixelscope' >/dev/null 2>&1 || "
                                   "break; done\n";
  for (const char* hide : {"xdotool windowfocus $window key alt+i || true", "xdotool set_desktop 1"}) {
    const Home home("hidden");
    home.plays("key `\nhold W\nwait frames 5\nprint window/size\nwait until window/visible off\nwait 500\n" + counts +
                   "wait 3000\n" + counts,
               std::string("xdotool windowfocus $window mousemove --window $window 200 200\nxdotool keydown f\n") +
                   "for i in $(seq 100); do " + hide + until_hidden + "sleep 1\nxdotool keyup f\n");
    const Activity hidden = activity(home.output);
    EXPECT_LT(hidden.turns, 20) << hide;
    EXPECT_EQ(hidden.frames, 0) << hide;
    EXPECT_EQ(hidden.drawn, 0) << hide;
  }
}

}  // namespace
}  // namespace ps::test::window_manager_test
