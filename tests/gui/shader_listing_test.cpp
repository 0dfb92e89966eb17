// The shaders in the window: which drew the pixel, with the values of their uniforms; a file that is written wrongly is
// named with its line while the picture stays, and one that is written well changes the picture.
#include <gtest/gtest.h>

#include <filesystem>

#include "base/atomic_file.h"
#include "base/resources.h"
#include "gui/panels/story/shader_rows.h"
#include "gui/program.h"
#include "support/environment.h"
#include "support/golden.h"
#include "support/option_contexts.h"
#include "support/run_cli.h"

namespace shader_listing_window_test {
namespace {

using namespace ps;

ShaderFile small_file() {
  return {"lighting.glsl",
          {{"uniform float exponent;", 1, true, {{"exponent", "20"}}}, {"float unused;", 2, false, {}}}};
}

TEST(ShaderRows, PutAMessageBesideItsLine) {
  const std::string message = "a shader does not compile: lighting.glsl:2(7): error: no";
  const auto rows = gui::shader_rows(small_file(), gui::ShaderLinesShown::whole, message);
  ASSERT_EQ(rows.size(), 2u);
  ASSERT_EQ(rows[0].values.size(), 1u);
  EXPECT_EQ(rows[0].values[0].name + rows[0].values[0].value, "exponent20");
  EXPECT_FALSE(rows[0].dimmed);
  EXPECT_TRUE(rows[1].dimmed);
  ASSERT_EQ(rows[1].values.size(), 1u);
  EXPECT_EQ(rows[1].values[0].value, "error: no") << "its place is where it stands";
  EXPECT_TRUE(gui::shader_rows(small_file(), gui::ShaderLinesShown::whole, "power.glsl:2(7): error")[1].values.empty())
      << "of another file";
  EXPECT_EQ(gui::file_of_message({small_file()}, message), 0);
  EXPECT_EQ(gui::file_of_message({small_file()}, "power.glsl:2(7): error"), -1);
}

TEST(ShaderRows, LeaveOutWhatTheProgramIsNotMadeOf) {
  const ShaderFile file{"a.glsl",
                        {{"#if TEXTURE", 1, true, {{"TEXTURE", "1"}}},
                         {"read();", 2, true, {}},
                         {"#else", 3, true, {}},
                         {"plain();", 4, false, {}},
                         {"#endif", 5, true, {}},
                         {"#if SHADOWS", 6, true, {{"SHADOWS", "0"}}},
                         {"shadow();", 7, false, {}},
                         {"#endif", 8, true, {}}}};
  std::vector<int> numbers;
  for (const ListingRow& row : gui::shader_rows(file, gui::ShaderLinesShown::compiled, ""))
    numbers.push_back(row.number);
  EXPECT_EQ(numbers, (std::vector<int>{1, 2}));
  EXPECT_EQ(gui::shader_rows(file, gui::ShaderLinesShown::whole, "").size(), 8u);
  EXPECT_EQ(gui::shader_rows(file, gui::ShaderLinesShown::compiled, "a.glsl:7(1): error").size(), 3u)
      << "the line that a message is about is shown";
}

/// A root with shaders of its own and everything else of the source tree.
std::filesystem::path own_root(const test::ScratchFolder& folder) {
  std::filesystem::path root = folder.path() / "root";
  std::filesystem::create_directories(root / "core/hardware");
  std::filesystem::copy(shader_file(""), root / "core/hardware/shaders");
  std::filesystem::create_directory_symlink(asset_dir(), root / "assets");
  std::filesystem::create_directory_symlink(chapter_dir(), root / "chapters");
  return root;
}

/// As a word of a script.
std::string script_word(const std::string& text) {
  std::string word = "\"";
  for (const char c : text) {
    if (c == '\n')
      word += "\\n";
    else if (c == '"' || c == '\\')
      word += std::string("\\") + c;
    else
      word += c;
  }
  return word + "\"";
}

TEST(ShaderListing, FollowsThePixelAndTheFiles) {
  if (!test::has_renderer("hardware")) GTEST_SKIP() << "this build has no hardware renderer";
  const auto folder = fresh_output_folder("gui-shader-listing");
  const test::ScratchFolder scratch;
  const std::filesystem::path root = own_root(scratch), power = root / "core/hardware/shaders/tints.glsl";
  const std::string good = read_whole_file(power);
  const std::string shots = folder.string() + "/";
  const std::string commands =
      "wait idle\nset renderer=hardware\nwait idle\nclick-pixel A 230,220\nwait idle\nchoose bottom listing\nwait "
      "idle\n"
      "expect listing/shader/draws 1\nexpect listing/shader/file fragment.glsl\n"
      "expect listing/shader/value/SHADING 1\nkeep listing/shader/value/surface_colour COLOUR\n"
      "keep a/picture PICTURE\n"
      "screenshot " +
      shots +
      "fragment.png\n"
      "click listing/fill\nwait idle\nscreenshot " +
      shots +
      "filled.png\n"
      "choose listing/part vertex\nwait frames 3\nexpect listing/shader/file vertex.glsl\n"
      "screenshot " +
      shots +
      "vertex.png\nchoose listing/part fragment\nwait frames 3\nkey Esc\nwait idle\n"
      // Another object has another colour.
      "click-pixel A 90,220\nwait idle\n"
      "expect-not listing/shader/value/surface_colour $COLOUR\n"
      "click-pixel A 230,220\nwait idle\nexpect listing/shader/value/surface_colour $COLOUR\n"
      // The lesson's routine is still there.
      "choose listing/code routine\nwait idle\nexpect listing/values > 0\nchoose listing/code shaders\nwait idle\n"
      // A mistake is named with its line; the picture stays.
      "write " +
      power.string() + " " + script_word("mistake\n" + good) +
      "\n"
      "wait until listing/shader/error contains tints.glsl:1\nwait idle\n"
      "expect listing/shader/file tints.glsl\nexpect listing/line-1 contains \"on disk\"\n"
      "screenshot " +
      shots +
      "error.png\nexpect a/picture $PICTURE\nexpect listing/shader/reloads 0\n"
      "write " +
      power.string() + " " + script_word(good + "// mended\n") +
      "\n"
      "wait until listing/shader/reloads 1\nwait idle\nexpect listing/shader/error \"\"\n"
      "expect a/picture $PICTURE\nscreenshot " +
      shots + "mended.png\nquit\n";
  const test::Variable variable("PIXELSCOPE_ROOT", root.string());
  const auto result = test::play(commands, folder, "1366x768", "cgfs/shading --size 300x300");
  EXPECT_EQ(result.status, 0) << result.errors << result.output;
  EXPECT_EQ(result.errors, "");
}

}  // namespace
}  // namespace shader_listing_window_test
