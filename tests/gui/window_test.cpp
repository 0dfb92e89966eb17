// Starting and ending the window: what it refuses, what it says, and that it rests while nothing happens.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <sstream>

#include "gui/program.h"
#include "image/file.h"
#include "support/golden.h"

namespace window_test {
namespace {

using ps::test::play;
using ps::test::run_window;

bool one_line(const std::string& text) {
  return std::count(text.begin(), text.end(), '\n') == 1 && text.back() == '\n';
}

TEST(Window, SaysThatThereIsNoDisplay) {
  const auto result = run_window("--widget-gallery", "env -u DISPLAY -u WAYLAND_DISPLAY -u SDL_VIDEODRIVER");
  EXPECT_EQ(result.status, 2);
  EXPECT_TRUE(one_line(result.errors)) << result.errors;
  EXPECT_NE(result.errors.find("no display"), std::string::npos) << result.errors;
}

/// Without a driver that shows windows, the window library would take one that does not.
TEST(Window, SaysThatADisplayDoesNotAnswer) {
  const auto result =
      run_window("--widget-gallery", "timeout 60 env -u WAYLAND_DISPLAY -u SDL_VIDEODRIVER DISPLAY=:4711");
  EXPECT_EQ(result.status, 2);
  EXPECT_NE(result.errors.find("no display answers at DISPLAY=':4711'"), std::string::npos) << result.errors;
}

TEST(Window, RefusesNumbersThatAreNone) {
  for (const char* arguments : {"--scale nan", "--scale inf", "--scale 5", "--scale 0x1", "--size 010x",
                                "--size nanxnan", "--size 4294967297x1", "--window-size nanxnan", "--set gamma=nan"}) {
    const auto result = run_window(arguments);
    EXPECT_EQ(result.status, 2) << arguments;
    EXPECT_TRUE(one_line(result.errors)) << arguments << ": " << result.errors;
  }
}

TEST(Window, SaysThatItCannotPrint) {
  for (const char* arguments : {"--help", "--version"}) {
    const auto result = run_window(arguments, "sh -c 'exec \"$@\" >/dev/full' sh");
    EXPECT_EQ(result.status, 2) << arguments;
    EXPECT_NE(result.errors.find("standard output cannot be written"), std::string::npos) << result.errors;
  }
}

TEST(Window, HelpNamesEveryArgument) {
  const auto result = run_window("--help");
  EXPECT_EQ(result.status, 0);
  for (const char* argument : {"SCENE", "--lesson", "--set", "--set-b", "--permalink", "--size", "--script", "--scale"})
    EXPECT_NE(result.output.find(argument), std::string::npos) << argument << " in: " << result.output;
}

TEST(Window, RefusesBadArguments) {
  for (const char* arguments : {"--no-such-option", "--scale 9", "--scale banana", "--script /no/such/file"}) {
    const auto result = run_window(arguments);
    EXPECT_EQ(result.status, 2) << arguments;
    EXPECT_TRUE(one_line(result.errors)) << arguments << ": " << result.errors;
  }
}

TEST(Window, FailedExpectationNamesTheLine) {
  const auto folder = ps::fresh_output_folder("gui-failed-expectation");
  const auto result =
      play("wait idle\nclick gallery/plain\nexpect gallery/count 7\n", folder, "800x600", "--widget-gallery");
  EXPECT_EQ(result.status, 1);
  EXPECT_NE(result.errors.find("script.script:3: gallery/count: found '1', expected = '7'"), std::string::npos)
      << result.errors;
}

TEST(Window, MisspeltControlNamesSimilarOnes) {
  const auto folder = ps::fresh_output_folder("gui-misspelt-control");
  const auto result = play("click options/plain\n", folder, "800x600", "--widget-gallery");
  EXPECT_EQ(result.status, 1);
  EXPECT_NE(result.errors.find("similar: gallery/plain"), std::string::npos) << result.errors;
}

// Eight pixels of the picture share each of the screen's: the click alone could not reach them all.
TEST(Window, EveryPixelOfAShrunkPictureCanBeClickedByAScript) {
  const auto folder = ps::fresh_output_folder("gui-shrunk-pixels");
  std::string script = "wait idle\nexpect zoom < 0.5\n";
  for (const char* pixel : {"300,420", "301,421", "302,422", "777,13", "778,14"})
    script += std::string("click-pixel A ") + pixel + "\nexpect pixel " + pixel + "\n";
  const auto result = play(script, folder, "1024x768", "--size 2200x1600 cgfs/spheres");
  EXPECT_EQ(result.status, 0) << result.errors;
}

TEST(Window, AValueIsNoControl) {
  const auto folder = ps::fresh_output_folder("gui-value-no-control");
  const auto result =
      play("wait idle\nclick bottom/space\nwait idle\nclick space/boxes\n", folder, "1024x768", "--size 160x120");
  EXPECT_EQ(result.status, 1);
  EXPECT_NE(result.errors.find("it is a value, which can be read and not clicked; similar: space/"), std::string::npos)
      << result.errors;
  EXPECT_EQ(result.errors.find("similar: space/boxes"), std::string::npos) << result.errors;
}

TEST(Window, IdleWindowDrawsNothing) {
  const auto folder = ps::fresh_output_folder("gui-idle");
  // The tooltip under the resting pointer comes within the first second.
  const auto result = play("wait idle\nwait 1000\nprint window/frames\nwait 1500\nprint window/frames\n", folder,
                           "1024x768", "--widget-gallery");
  ASSERT_EQ(result.status, 0) << result.errors;
  std::istringstream lines(result.output);
  int before = 0, after = 0;
  ASSERT_TRUE(lines >> before >> after) << result.output;
  EXPECT_GT(before, 0);
  EXPECT_EQ(after, before);
}

// A frame like the one before is laid out, but not drawn; anything that changes is.
TEST(Window, DrawsNoFrameTwice) {
  const auto folder = ps::fresh_output_folder("gui-no-frame-twice");
  const auto result = play("wait idle\nwait frames 4\nprint window/frames-drawn\nwait frames 30\n"
                           "print window/frames-drawn\nset exposure=2\nwait idle\nprint window/frames-drawn\n"
                           "resize 900x700\nwait idle\nprint window/frames-drawn\n",
                           folder, "1024x768", "--size 160x120");
  ASSERT_EQ(result.status, 0) << result.errors;
  std::istringstream lines(result.output);
  int before = 0, after = 0, changed = 0, resized = 0;
  ASSERT_TRUE(lines >> before >> after >> changed >> resized) << result.output;
  EXPECT_GT(before, 0);
  EXPECT_EQ(after, before);
  EXPECT_GT(changed, after);
  EXPECT_GT(resized, changed);
}

// With drawing off, what changes is laid out, and drawn only for a screenshot.
TEST(Window, AScriptTurnsDrawingOff) {
  const auto folder = ps::fresh_output_folder("gui-drawing-off");
  const std::string counts = "print window/frames-drawn\nprint window/frames\n", shot = (folder / "shot.png").string();
  const auto result =
      play("wait idle\ndraw off\n" + counts + "set exposure=2\nresize 900x700\nwait idle\n" + counts + "screenshot " +
               shot + "\nwait frames 3\n" + counts + "draw on\nset exposure=1\nwait idle\n" + counts,
           folder, "1024x768", "--size 160x120");
  ASSERT_EQ(result.status, 0) << result.errors;
  std::istringstream lines(result.output);
  std::array<int, 4> drawn{}, laid_out{};
  for (std::size_t i = 0; i < drawn.size(); ++i) ASSERT_TRUE(lines >> drawn[i] >> laid_out[i]) << result.output;
  EXPECT_EQ(drawn[1], drawn[0]);
  EXPECT_GT(laid_out[1], laid_out[0]);
  EXPECT_EQ(drawn[2], drawn[1] + 1);
  EXPECT_GT(drawn[3], drawn[2]);
  const auto picture = ps::load_levels(shot);
  EXPECT_EQ(picture.width(), 900);
  EXPECT_EQ(picture.height(), 700);
}

TEST(Window, RemembersTypeSizeAndTheme) {
  const auto folder = ps::fresh_output_folder("gui-remembered");
  const std::string state = "env XDG_STATE_HOME=" + std::filesystem::absolute(folder).string();
  const auto script = [&](const std::string& name, const std::string& commands) {
    return run_window(
        "--widget-gallery --script " +
            [&] {
              const auto path = folder / name;
              std::ofstream(path) << commands;
              return path.string();
            }(),
        state);
  };
  const auto first =
      script("first.script", "key Ctrl++\nkey Ctrl++\nclick menu/view\nclick menu/dark-theme\nwait idle\n"
                             "print window/scale\nprint window/theme\n");
  ASSERT_EQ(first.status, 0) << first.errors;
  const auto second = script("second.script", "wait idle\nprint window/scale\nprint window/theme\n");
  EXPECT_EQ(second.output, first.output);
  EXPECT_NE(first.output.find("dark"), std::string::npos) << first.output;
  EXPECT_EQ(first.output.find("1\n"), std::string::npos) << first.output;
}

// Offered once, to those who start without asking for anything, and never again once it is answered.
TEST(Window, OffersAFirstLookOnce) {
  const auto folder = ps::fresh_output_folder("gui-first-look");
  const auto start = [&](const std::string& state_folder, const std::string& arguments, const std::string& commands) {
    const auto path = folder / "first-look.script";
    std::ofstream(path) << "wait idle\n" << commands << "quit\n";
    const std::string state = "env XDG_STATE_HOME=" + std::filesystem::absolute(folder / state_folder).string();
    const auto result = run_window(arguments + " --script " + path.string(), state);
    EXPECT_EQ(result.status, 0) << result.errors;
  };
  start("asked", "cgfs/cubes", "expect first-look/offered off\n");
  start("taken", "", "click first-look/start\nwait idle\nexpect step 1\nexpect first-look/offered off\n");
  start("taken", "", "expect first-look/offered off\n");
  start("declined", "", "click first-look/not-now\nwait idle\nexpect first-look/offered off\n");
  start("declined", "", "expect first-look/offered off\n");
  start("passed", "", "expect first-look/offered on\nkey ]\nwait idle\nexpect first-look/offered off\n");
  start("passed", "", "expect first-look/offered off\n");
}

// At both, everything that a lesson needs can be reached.
TEST(Window, WorksSmallAndAtDoubleScale) {
  const std::string script =
      "wait idle\nexpect step 1\nkey Shift+PageDown\nwait idle\nexpect step 2\nkey F3\nwait idle\n"
      "choose options/a/renderer rasterizer\n"
      "click pixel/side/b\nclick menu\nclick menu/view\nkey Esc\nkey ?\nexpect help/open on\nkey Esc\nkey X\nwait "
      "idle\n"
      "keep split BEFORE\ndrag pictures/divider 30,0\nexpect split > $BEFORE\nexpect messages 0\n";
  struct Case {
    std::string size, scale;
  };
  for (const Case& one : {Case{"800x600", "1"}, Case{"1920x1080", "2"}}) {
    const auto folder = ps::fresh_output_folder("gui-sizes-" + one.size);
    const auto result = play(script, folder, one.size, "--lesson cgfs_14_textures --size 160x120 --scale " + one.scale);
    EXPECT_EQ(result.status, 0) << one.size << ": " << result.errors;
    EXPECT_EQ(result.errors, "");
  }
}

}  // namespace
}  // namespace window_test
