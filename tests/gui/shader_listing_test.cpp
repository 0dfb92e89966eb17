// The shaders in the window, as the driver got them; a file that is written wrongly is named with its line while the
// picture stays, and one that is written well changes the picture.
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

/// As hardware/shader_text.h makes it of a file that includes another.
ShaderText small_text() {
  return {"#version 330 core\n#define LIGHTS 3\n#line 1 0\nfirst();\n#ifndef INCLUDED_tints_glsl\n"
          "#define INCLUDED_tints_glsl\n#line 1 1\nint tint;\n#endif\n#line 3 0\nthird();\n",
          {"vertex.glsl", "tints.glsl"}};
}

TEST(ShaderRows, AreTheTextAsItIs) {
  std::string text;
  int number = 0;
  for (const ListingRow& row : gui::shader_rows(small_text())) {
    text += row.text + "\n";
    EXPECT_EQ(row.number, ++number);
  }
  EXPECT_EQ(text, small_text().text);
  const auto files = gui::file_places(small_text());
  ASSERT_EQ(files.size(), 2u);
  EXPECT_EQ(files[0].name + files[1].name, "vertex.glsltints.glsl");
  EXPECT_EQ(files[0].row, 4);
  EXPECT_EQ(files[1].row, 8);
}

TEST(ShaderRows, HaveAMessageAtItsLine) {
  const auto faults = [](const char* place) {
    return gui::shader_faults(small_text(), std::string("a shader does not compile: ") + place + ": error: no");
  };
  using Faults = std::map<int, std::string>;
  EXPECT_EQ(faults("vertex.glsl:1(7)"), (Faults{{4, "error: no"}}));
  EXPECT_EQ(faults("tints.glsl:1"), (Faults{{8, "error: no"}}));
  EXPECT_EQ(faults("vertex.glsl:3"), (Faults{{11, "error: no"}})) << "and not what guards the other file";
  for (const char* other : {"vertex.glsl:9", "volume_vertex.glsl:1", "power.glsl:1"})
    EXPECT_EQ(faults(other), Faults{});
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
      "expect listing/shader/draws 1\nexpect listing/shader/text contains \"#define SHADING 1\"\n"
      "expect listing/shader/text contains fragment_colour\nexpect listing/first-line > 20\n"
      "keep a/picture PICTURE\n"
      "screenshot " +
      shots +
      "fragment.png\n"
      "click listing/fill\nwait idle\nscreenshot " +
      shots +
      "filled.png\n"
      "choose listing/part vertex\nwait frames 3\nexpect listing/shader/text contains gl_Position\n"
      "screenshot " +
      shots +
      "vertex.png\nchoose listing/part fragment\nwait frames 3\n"
      "choose listing/file story.glsl\nwait idle\nscreenshot " +
      shots + "last.png\nchoose listing/file definitions\nwait idle\nexpect listing/first-line 1\nscreenshot " + shots +
      "definitions.png\nchoose listing/file tints.glsl\nwait idle\nexpect listing/first-line > 20\nkey Esc\nwait "
      "idle\n"
      // The lesson's routine is still there.
      "choose listing/code routine\nwait idle\nexpect listing/values > 0\nchoose listing/code shaders\nwait idle\n"
      // A mistake is named with its line; the picture stays.
      "write " +
      power.string() + " " + script_word("mistake\n" + good) +
      "\n"
      "wait until listing/shader/error contains tints.glsl:1\nwait idle\n"
      "expect listing/shader/error contains syntax\n"
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
