// Pictures come first: how much of the window A and B take in each mode, at the sizes of old and new screens, with
// common and with large type. The window's own figure is counted again in a screenshot.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <vector>

#include "gui/program.h"
#include "image/file.h"
#include "support/golden.h"

namespace window_shares_test {
namespace {

constexpr double lesson_share = 35, explore_share = 30;  // percent of the window, for square pictures
constexpr double tool_share = 14;                        // beside a tall tool

/// What each `print` of the commands wrote, as numbers. Nothing is drawn: what is printed is about the layout.
std::vector<double> printed(const std::string& commands, const std::string& name, const std::string& size,
                            const std::string& arguments) {
  const auto result = ps::test::play("draw off\n" + commands, ps::fresh_output_folder(name), size, arguments);
  EXPECT_EQ(result.status, 0) << result.errors;
  std::string output = result.output;
  std::replace(output.begin(), output.end(), ',', ' ');  // places are "x,y"
  std::istringstream lines(output);
  std::vector<double> numbers;
  for (double number = 0; lines >> number;) numbers.push_back(number);
  return numbers;
}

struct Screen {
  std::string size, type;  ///< type: --scale
};

std::string name_of(const testing::TestParamInfo<Screen>& info) {
  std::string name = info.param.size + "_type_" + info.param.type;
  for (char& c : name)
    if (c == '.') c = '_';
  return name;
}

class WindowShares : public testing::TestWithParam<Screen> {};

TEST_P(WindowShares, LessonsKeepTheirPicturesLarge) {
  const auto& [size, type] = GetParam();
  const auto shares =
      printed("wait idle\nprint window/pictures-share\nkey Shift+PageDown\nwait idle\nprint window/pictures-share\n",
              "gui-share-lesson", size, "--scale " + type + " --lesson cgfs_04_shadows_and_reflections/5");
  ASSERT_EQ(shares.size(), 2u);
  for (const double share : shares) EXPECT_GE(share, lesson_share) << size << ", type " << type;
}

TEST(LessonText, HasLinesOfReadableLength) {
  for (const std::string size : {"1366x768", "1920x1080"}) {
    const auto length =
        printed("wait idle\nprint lesson/line-length\nkey Shift+PageDown\nwait idle\nprint lesson/line-length\n",
                "gui-line-length", size, "--lesson cgfs_04_shadows_and_reflections");
    ASSERT_EQ(length.size(), 2u);
    for (const double characters : length) {
      EXPECT_GE(characters, 57) << size;
      EXPECT_LE(characters, 66) << size;
    }
  }
}

/// intersect_ray_sphere of the lesson's listing.cpp, the first routine with values at the step's pixel.
constexpr int routine_begins = 26;

class TallTool : public testing::TestWithParam<Screen> {};

TEST_P(TallTool, HasItsRoomBesideThePicture) {
  const auto& [size, type] = GetParam();
  const std::string share = "print window/pictures-share\n";
  const auto numbers =
      printed("wait idle\nclick predict/skip\nwait idle\nchoose stage listing\nwait idle\n" + share +
                  "print listing/lines\nprint listing/first-line\nchoose stage chart\nwait frames 6\n" + share +
                  "print chart/plot-height\n",
              "gui-beside", size, "--scale " + type + " --lesson cgfs_04_shadows_and_reflections");
  ASSERT_EQ(numbers.size(), 5u);
  EXPECT_GE(numbers[0], tool_share);
  EXPECT_GE(numbers[1], 24);
  EXPECT_LE(numbers[2], routine_begins);
  EXPECT_GE(numbers[3], tool_share);
  EXPECT_GE(numbers[4], 300);
}

INSTANTIATE_TEST_SUITE_P(Screens, TallTool,
                         testing::Values(Screen{"1024x768", "1"}, Screen{"1366x768", "1"}, Screen{"1024x768", "1.5"},
                                         Screen{"1366x768", "1.5"}, Screen{"1920x1080", "1.5"}),
                         name_of);

/// The step compares in one picture with a divider, beside a chart. The largest arrangement has to win.
TEST_P(WindowShares, ATallToolLeavesThePicturesTheirShare) {
  const auto& [size, type] = GetParam();
  const auto shares =
      printed("wait idle\nprint window/pictures-share\nkey Shift+PageDown\nwait idle\n"
              "click question/skip\nwait idle\nexpect compare split\nexpect stage chart\nprint window/pictures-share\n",
              "gui-share-tall", size, "--scale " + type + " --lesson study_speed_and_accuracy/2");
  ASSERT_EQ(shares.size(), 2u);
  for (const double share : shares) EXPECT_GE(share, tool_share) << size << ", type " << type;
}

TEST_P(WindowShares, ExploringKeepsThePicturesLarge) {
  const auto& [size, type] = GetParam();
  // First with a hint in the story's place, then with the story.
  const auto shares =
      printed("wait idle\nexpect pixel-panel on\nprint window/pictures-share\nclick-pixel A 200,300\nwait idle\n"
              "expect pixel-panel on\nexpect window/cut \"\"\nprint window/pictures-share\n",
              "gui-share-explore", size, "--scale " + type);
  ASSERT_EQ(shares.size(), 2u);
  for (const double share : shares) EXPECT_GE(share, explore_share) << size << ", type " << type;
}

INSTANTIATE_TEST_SUITE_P(Screens, WindowShares,
                         testing::Values(Screen{"1024x768", "1"}, Screen{"1366x768", "1"}, Screen{"1920x1080", "1"},
                                         Screen{"3840x2160", "2"}, Screen{"1024x768", "1.5"}, Screen{"1366x768", "1.5"},
                                         Screen{"1920x1080", "1.5"}, Screen{"3840x2160", "3"}),
                         name_of);

TEST(PictureTitles, StandOverTheirPartsOfASplitPicture) {
  const std::string places = "print pictures/divider@middle\nprint view/a/title@middle\nprint view/b/title@middle\n";
  for (const std::string by : {"230,0", "-150,0"}) {
    const auto at = printed("wait idle\nkey X\nwait idle\ndrag pictures/divider " + by + "\nwait idle\n" + places,
                            "gui-split-titles", "1366x768", "");
    ASSERT_EQ(at.size(), 6u);
    EXPECT_LT(at[2], at[0]) << "A's title is left of the divider, moved by " << by;
    EXPECT_GT(at[4], at[0]) << "and B's right of it";
    EXPECT_LT(at[4] - at[0], 200) << "close to it";
  }
}

TEST(PictureTitles, BeginWhereAnEnlargedPictureDoes) {
  // The picture fills its place, wherever a fitted one would begin.
  const auto at = printed("wait idle\nprint view/a/picture@middle\nprint view/a/title@middle\n", "gui-title-zoomed",
                          "1366x768", "--lesson cgfs_04_shadows_and_reflections/4");
  ASSERT_EQ(at.size(), 4u);
  EXPECT_NEAR(at[0], at[2], 8) << "a brief title is as wide as its picture";
}

/// A disc of one colour on another: without mixtures at its edge, its pixels are not equally wide.
TEST(EnlargedPicture, HasPixelsOfEqualWidth) {
  const auto folder = ps::fresh_output_folder("gui-equal-pixels");
  std::ofstream(folder / "disc.scene") << "canvas_size = 600 x 600\nbackground = (255, 0, 255)\n"
                                       << "sphere { center = (0, 0, 5) radius = 1 color = (0, 255, 0) }\n"
                                       << "light { type = ambient intensity = 1 }\n";
  // Letters and marks are grey.
  const auto mixed_at = [&](const std::string& zoom) {
    const std::string shot = (folder / "window.png").string();
    const auto result = ps::test::play("wait idle\nmove view/a/picture\n" + zoom + "wait idle\nscreenshot " + shot,
                                       folder, "1366x768", (folder / "disc.scene").string());
    EXPECT_EQ(result.status, 0) << result.errors;
    const auto picture = ps::load_levels(shot);
    int mixed = 0;
    for (const ps::Rgb8& p : picture.pixels())
      mixed += p.r > 20 && p.r < 235 && std::abs(p.r + p.g - 255) < 4 && p.r == p.b && std::abs(p.r - p.g) > 8 ? 1 : 0;
    return mixed;
  };
  EXPECT_GT(mixed_at("wheel 2\n"), 400) << "1.25 times";
  EXPECT_LT(mixed_at("key 1\n"), 100) << "one to one: a few pixels of letters";
}

TEST(PicturesShare, IsTheShareOfTheWindowThatHasThePicturesColour) {
  const auto folder = ps::fresh_output_folder("gui-share-flat");
  // Nothing but background, in a colour that the window has nowhere else.
  std::ofstream(folder / "flat.scene") << "canvas_size = 600 x 600\nbackground = (255, 0, 255)\n"
                                       << "sphere { center = (0, 0, -5) radius = 1 color = (1, 2, 3) }\n";
  const std::string shot = (folder / "window.png").string();
  for (const std::string keys : {"", "key F2\n", "key X\n"}) {
    const auto result =
        ps::test::play("wait idle\n" + keys + "wait idle\nprint window/pictures-share\nscreenshot " + shot + "\n",
                       folder, "1366x768", (folder / "flat.scene").string());
    ASSERT_EQ(result.status, 0) << result.errors;
    const auto picture = ps::load_levels(shot);
    double seen = 0;
    for (int y = 0; y < picture.height(); ++y)
      for (int x = 0; x < picture.width(); ++x) seen += picture.at(x, y) == ps::Rgb8{255, 0, 255} ? 1 : 0;
    const double counted = 100 * seen / (picture.width() * picture.height());
    // The split's divider and the marks of handles lie over the pictures.
    EXPECT_NEAR(std::stod(result.output), counted, 0.5) << keys;
    EXPECT_GT(counted, 20);
  }
}

}  // namespace
}  // namespace window_shares_test
