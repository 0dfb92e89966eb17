// What is kept from one start to the next under a name, and files that a key saves at once.
#include "gui/panels/kept/kept_list.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>

#include "gui/frame/shots.h"
#include "gui/panels/pictures/first_nan.h"
#include "gui/program.h"
#include "image/file.h"
#include "support/golden.h"

namespace ps::gui::kept_test {
namespace {

TEST(KeptList, LinesReadBack) {
  std::vector<KeptEntry> entries;
  EXPECT_TRUE(keep_entry(entries, "soft", "shadows=pcf"));
  EXPECT_TRUE(keep_entry(entries, "  two\twords \n", ""));
  EXPECT_FALSE(keep_entry(entries, " \t ", "x"));
  EXPECT_TRUE(keep_entry(entries, "soft", "shadows=none"));
  const std::vector<KeptEntry> expected{{"soft", "shadows=none"}, {"two words", ""}};
  EXPECT_EQ(entries, expected);
  EXPECT_EQ(parse_kept(kept_lines(entries)), expected);
  EXPECT_EQ(parse_kept("no tab\n\tno name\na\tb\tc\n"), (std::vector<KeptEntry>{{"a", "b\tc"}}));
}

TEST(FirstNan, IsTheFirstInReadingOrder) {
  Image<Vec3f> colour(3, 2);
  EXPECT_FALSE(first_not_finite(colour));
  colour.at(0, 1).y = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(first_not_finite(colour), Vec2i(0, 1));
  colour.at(2, 0).z = -std::numeric_limits<float>::infinity();
  EXPECT_EQ(first_not_finite(colour), Vec2i(2, 0));
}

TEST(Shots, AreNamedAfterSceneAndTime) {
  std::tm time{};
  time.tm_year = 125;
  time.tm_mday = 31;
  time.tm_hour = 9;
  EXPECT_EQ(shot_name("cgfs/shadows", time), "cgfs-shadows-20250131-090000");
  EXPECT_EQ(shot_name("/home/me/my scene.scene", time), "my-scene-20250131-090000");
  const auto folder = fresh_output_folder("gui-free-shot");
  EXPECT_EQ(free_name(folder, "x", "-a"), "x");
  std::ofstream(folder / "x-a.png") << "there";
  EXPECT_EQ(free_name(folder, "x", "-a"), "x-2");
  EXPECT_EQ(free_name(folder, "x", "-b"), "x");
}

/// Starts the window with a state folder of its own, plays commands and ends it.
test::WindowRun start(const std::filesystem::path& folder, const std::string& commands) {
  std::ofstream(folder / "play.script") << "wait idle\n" << commands << "quit\n";
  return test::run_window("--script " + (folder / "play.script").string() + " --window-size 1024x768 --size 120x120",
                          "timeout 60 env XDG_STATE_HOME=" + folder.string() +
                              " XDG_PICTURES_DIR=" + (folder / "pictures").string());
}

TEST(Kept, PresetsAndBookmarksAreThereAtTheNextStart) {
  const auto folder = std::filesystem::absolute(fresh_output_folder("gui-kept"));
  std::filesystem::create_directories(folder / "pixelscope");
  auto run = start(folder, "set shadows=none\nkey M\nwait frames 3\nclick kept/preset-name\ntype bare\n"
                           "click kept/keep-a\nclick kept/bookmark-name\ntype here\nclick kept/bookmark\n"
                           "wait frames 3\n");
  ASSERT_EQ(run.status, 0) << run.errors;
  run =
      start(folder, "set shadows=traced\nkey M\nwait frames 3\nclick kept/preset/0/a\nwait idle\n"
                    "expect a/option/shadows none\nkey Ctrl+Z\nwait idle\nexpect-not a/option/shadows none\n"
                    "click kept/bookmark/0/open\nwait idle\nexpect a/option/shadows none\n"
                    "key M\nwait frames 3\nclick kept/preset/0/delete\nclick kept/bookmark/0/delete\nwait frames 3\n");
  EXPECT_EQ(run.status, 0) << run.errors;
  run = start(folder, "key Ctrl+K\ntype \"bare into A\"\nwait frames 2\nkey Enter\nwait idle\n"
                      "expect-not undo \"preset bare into A\"\n");
  EXPECT_EQ(run.status, 0) << run.errors;
}

// A lesson that was read to its last page, and no other one, has its tick in the list and in the picker.
TEST(Kept, TicksOfLessonsAreThereAtTheNextStart) {
  const auto folder = std::filesystem::absolute(fresh_output_folder("gui-kept-ticks"));
  std::filesystem::create_directories(folder / "pixelscope");
  std::string read =
      "key F2\nwait idle\nexpect lessons/linear_algebra/read off\nclick lessons/linear_algebra\nwait idle\n";
  for (int step = 1; step < 7; ++step) read += "key Shift+PageDown\nwait frames 3\n";
  read += "expect step 7\nkey PageDown\nwait frames 3\nclick lesson/close\nwait idle\n";
  auto run = start(folder, read);
  ASSERT_EQ(run.status, 0) << run.errors;
  run = start(folder, "key F2\nwait idle\nexpect lessons/linear_algebra/read on\n"
                      "expect lessons/a_first_look/read off\nkey Ctrl+L\nwait frames 3\n"
                      "expect picker/linear_algebra/read on\nexpect picker/a_first_look/read off\n");
  EXPECT_EQ(run.status, 0) << run.errors;
}

TEST(Shots, AKeySavesThePicturesAndOneTheWindow) {
  const auto folder = std::filesystem::absolute(fresh_output_folder("gui-shots"));
  std::filesystem::create_directories(folder / "pictures");
  const auto run =
      start(folder, "key Shift+P\nwait idle\nexpect message contains \"-a.png\"\nexpect message contains " +
                        (folder / "pictures").string() +
                        "\nkey Ctrl+P\nwait frames 3\nexpect message contains \"-window.png\"\n");
  ASSERT_EQ(run.status, 0) << run.errors;
  std::set<std::pair<int, int>> sizes;
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "pictures")) {
    EXPECT_TRUE(entry.path().filename().string().starts_with("cgfs-reflections-")) << entry.path();
    const auto picture = load_levels(entry.path());
    sizes.insert({picture.width(), picture.height()});
    ++count;
  }
  EXPECT_EQ(count, 3u);
  EXPECT_EQ(sizes, (std::set<std::pair<int, int>>{{120, 120}, {1024, 768}}));
}

}  // namespace
}  // namespace ps::gui::kept_test
