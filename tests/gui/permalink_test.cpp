// Everything on the screen as a line of text, as a file, inside a saved picture, and as a command: each brings the same
// screen back.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <ostream>
#include <string>

#include "base/atomic_file.h"
#include "document/command_line.h"
#include "document/permalink.h"
#include "document/permalink_file.h"
#include "gui/program.h"
#include "image/file.h"
#include "support/golden.h"

namespace permalink_test {
namespace {

using ps::test::play;
using ps::test::read_file;

/// A screen to bring back: what it opens with, how it is arranged, and what must be the same again.
struct Screen {
  const char* folder;
  const char* scene;
  const char* arrange;  ///< ends idle
  const char* expect;
};

void PrintTo(const Screen& screen, std::ostream* out) { *out << screen.folder; }

/// Options on both sides, another camera and pixel, a selected event, the tab of both stories, another tab below.
constexpr Screen options_and_camera{"gui-permalink", "cgfs/reflections", R"(set reflection-depth=1
set-b shading=flat
key Ctrl+Left
click-pixel B 210,420
wait idle
choose pixel/side both
choose bottom timings
key .
key .
wait idle
)",
                                    R"(expect picked B
expect selected-event > 0
expect pixel/side both
expect bottom/timings on
)"};

/// The view from outside turned by hand and gone through up to an event, a line of the listing stepped to, a kept
/// vertex with a step of its way changed, the microscope's point moved off the sample.
constexpr Screen views_of_the_story{"gui-permalink-views", "cgfs/crates", R"(set renderer=rasterizer
choose bottom vertex
wait idle
click vertex/next
wait idle
choose vertex/order move-then-turn
choose bottom listing
wait idle
click listing/fill
wait idle
click listing/line-61/next
wait idle
key Esc
choose bottom microscope
wait idle
drag microscope/pixel 30,20
wait idle
choose bottom space
wait idle
drag space/view 60,20
wait idle
key .
key .
key .
wait idle
)",
                                    R"(expect selected-event > 0
expect space/up-to > -1
expect-not space/orbit none
choose bottom vertex
wait idle
expect vertex/order move-then-turn
choose bottom listing
wait idle
expect listing/focus > -1
choose bottom microscope
wait idle
expect-not microscope/pixel 0.5,0.5
)"};

/// A pixel pinned with other options, from another place, under another light.
constexpr Screen pinned_pixel{"gui-permalink-pin", "cgfs/reflections", R"(click-pixel A 300,310
wait idle
set reflection-depth=1
set-b shading=flat
key I
wait idle
click pixel/pin
wait idle
set reflection-depth=3
set-b shading=phong
key Ctrl+Left
wait idle
)",
                              R"(expect pixel/pin on
expect pixel/pin/options contains "reflection-depth"
expect pixel/pin/options contains "camera"
expect pixel/pin/display contains "→"
)"};

/// A part of the picture alone, against a picture from a file that was made with other options.
constexpr Screen rectangle_and_picture{"gui-permalink-picture", "cgfs/reflections", R"(set reflection-depth=0
wait idle
key P
wait frames 3
type OUT/theirs.png
key Enter
wait idle
set reflection-depth=3
click menu/scene
click picture-b
wait frames 3
type OUT/theirs-a.png
key Enter
wait idle
drag view/a/picture 60,40 shift
wait idle
)",
                                       R"(expect-not region all
expect picture-b "OUT/theirs-a.png"
expect view/b/title contains "theirs-a.png"
expect identical off
expect a/counter/eye-rays < 60000
key Esc
set reflection-depth=0
wait idle
expect identical on
)"};

std::string with_folder(std::string script, const std::string& folder) {
  for (auto at = script.find("OUT"); at != std::string::npos; at = script.find("OUT", at + folder.size()))
    script.replace(at, 3, folder);
  return script;
}

class PermalinkScreen : public testing::TestWithParam<Screen> {};

TEST_P(PermalinkScreen, FourWaysBringItBack) {
  const Screen& screen = GetParam();
  const auto folder = std::filesystem::absolute(ps::fresh_output_folder(screen.folder));
  const std::string file = std::filesystem::absolute(folder / "screen.permalink").string();
  const std::string picture = std::filesystem::absolute(folder / "picture.png").string();
  const std::string arrange = with_folder(screen.arrange, folder.string());
  const std::string expect = with_folder(screen.expect, folder.string());
  const std::string saving = "wait idle\n" + arrange + "keep permalink LINK\nprint permalink\n" +
                             "key P\nwait frames 3\ntype " + picture + "\nkey Enter\nwait idle\n" +
                             "key Ctrl+Shift+S\nwait frames 3\ntype " + file + "\nkey Enter\nwait idle\n" +
                             "expect permalink $LINK\nscreenshot " + (folder / "before.png").string() + "\n" +
                             "key Shift+C\nwait frames 2\nprint clipboard\n" +
                             "key Ctrl+K\nwait frames 2\ntype \"opens this screen\"\nkey Enter\nwait frames 2\n" +
                             "print clipboard\n" + expect + "quit\n";
  const auto saved = play(saving, folder, "1280x800", screen.scene);
  ASSERT_EQ(saved.status, 0) << saved.errors << saved.output;
  const auto end = saved.output.find('\n');
  std::string link = saved.output.substr(0, end);
  if (const auto equals = link.find("scene="); equals != std::string::npos) link = link.substr(equals);
  ASSERT_NE(link.find("pixel="), std::string::npos) << link;

  EXPECT_EQ(ps::permalink_in_file(file), link);
  const std::string in_picture = ps::permalink_in_file(folder / "picture-a.png").value_or("");
  EXPECT_EQ(in_picture, link);

  // The line must be the same before anything is clicked, and what it stands for must be on the screen.
  const std::string same = "wait idle\nexpect permalink \"" + link + "\"\n" + expect;
  const auto by_text = play(same, folder, "1280x800", "--permalink '" + link + "'");
  EXPECT_EQ(by_text.status, 0) << by_text.errors;
  const auto by_file = play(same, folder, "1280x800", "'" + file + "'");
  EXPECT_EQ(by_file.status, 0) << by_file.errors;
  const auto by_picture = play(same, folder, "1280x800", "'" + (folder / "picture-a.png").string() + "'");
  EXPECT_EQ(by_picture.status, 0) << by_picture.errors;

  // The commands that the window puts on the clipboard, as a shell reads them: one makes the picture of the picked side
  // without a window, the other opens the screen again.
  const auto printed = [&](const std::string& start) {
    const auto begins = saved.output.find(start, end);
    return begins == std::string::npos ? "" : saved.output.substr(begins, saved.output.find('\n', begins) - begins);
  };
  const std::string render = printed("pixelscope-cli render --permalink");
  ASSERT_FALSE(render.empty()) << saved.output;
  const std::string alone = (folder / "alone.png").string();
  const std::string made = render.substr(0, render.find("--out")) + "--out " + ps::shell_quote(alone);
  ASSERT_EQ(std::system((PIXELSCOPE_BIN_DIR "/" + made).c_str()), 0) << made;
  const std::string shown = folder / (link.find("picked=b") == std::string::npos ? "picture-a.png" : "picture-b.png");
  const auto levels = ps::load_levels(alone), wanted = ps::load_levels(shown);
  const auto region =
      ps::parse_permalink(link).view.region.value_or(ps::TileRect{0, 0, wanted.width(), wanted.height()});
  ASSERT_EQ(levels.width(), wanted.width());
  for (int y = region.y0; y < region.y1; ++y)
    for (int x = region.x0; x < region.x1; ++x) ASSERT_EQ(levels.at(x, y), wanted.at(x, y)) << x << "," << y;
  const std::string window = printed("pixelscope --permalink");
  ASSERT_FALSE(window.empty()) << saved.output;
  const std::string command = window.substr(std::string("pixelscope ").size());
  const auto by_command = play(same, folder, "1280x800", command);
  EXPECT_EQ(by_command.status, 0) << by_command.errors;

  // And in a window that shows something else.
  const auto opened = play("wait idle\nopen " + file + "\nwait idle\n" + same, folder, "1280x800", "cgfs/cubes");
  EXPECT_EQ(opened.status, 0) << opened.errors;
}

INSTANTIATE_TEST_SUITE_P(Permalink, PermalinkScreen,
                         testing::Values(options_and_camera, views_of_the_story, pinned_pixel, rectangle_and_picture),
                         [](const auto& tested) {
                           std::string name(tested.param.folder);
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

/// A screen with a picture in B's place that is not to be had any longer: the rest of it comes as it was.
void expect_all_but_the_picture(const std::filesystem::path& folder, const std::string& picture,
                                const std::string& message) {
  const std::string link = "scene=cgfs/reflections&region=100,200,300,250&picture-b=" + picture +
                           "&pixel=312,304&event=5&compare=split&a.reflection-depth=1&b.renderer=rasterizer";
  const auto run =
      play("wait idle\nexpect scene cgfs/reflections\nexpect picture-b none\nexpect message contains \"" + message +
               R"("
expect region 100,200,300,250
expect pixel 312,304
expect selected-event 5
expect compare split
expect a/option/reflection-depth 1
expect b/option/renderer rasterizer
expect b/state done
quit
)",
           folder, "1280x800", "--permalink '" + link + "'");
  EXPECT_EQ(run.status, 0) << run.errors;
}

TEST(PermalinkPicture, OneThatIsGoneLosesNothingElse) {
  const auto folder = ps::fresh_output_folder("gui-permalink-gone");
  expect_all_but_the_picture(folder, (folder / "gone.png").string(), "gone.png");
}

TEST(PermalinkPicture, OneOfAnotherSizeLosesNothingElse) {
  const auto folder = ps::fresh_output_folder("gui-permalink-size");
  const auto small = folder / "small.png";
  ps::save_image(small, ps::Image<ps::Rgb8>(40, 30));
  expect_all_but_the_picture(folder, small.string(), "has 40 x 30 pixels, where the picture has 600 x 600");
}

// Undo takes a pin back and brings it again, with the numbers of then.
TEST(Pin, UndoBringsItBack) {
  const auto folder = ps::fresh_output_folder("gui-pin-undo");
  const auto run = play(R"(wait idle
click-pixel A 300,310
wait idle
click pixel/pin
wait idle
set reflection-depth=0
wait idle
expect pixel/pin/options contains "reflection-depth=0"
keep pixel/pin/display CHANGE
click pixel/pin
wait idle
expect pixel/pin off
key Ctrl+Z
wait idle
expect pixel/pin on
expect pixel/pin/display $CHANGE
quit
)",
                        folder, "1280x800", "cgfs/reflections");
  EXPECT_EQ(run.status, 0) << run.errors;
}

}  // namespace
}  // namespace permalink_test
