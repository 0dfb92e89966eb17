// The words that people type into the palette lead right with its first line. Most are those of a trial of the window
// in which 17 of 50 led nowhere.
#include <gtest/gtest.h>

#include <array>
#include <sstream>
#include <string>

#include "gui/program.h"
#include "gui/shell/palette_fit.h"
#include "support/golden.h"

namespace palette_words_test {
namespace {

using ps::gui::palette_fit;
using ps::gui::PaletteFit;

struct Word {
  const char *typed, *first;  ///< the name of the line that Enter takes
};

constexpr std::array words{
    Word{"depth buffer", "technique/depth-buffer/off"},
    Word{"z-buffer", "technique/depth-buffer/off"},
    Word{"backface", "technique/culling/off"},
    Word{"gouraud", "technique/shading/gouraud"},
    Word{"mipmap", "technique/texture-filter/mipmap"},
    Word{"minification", "option/texture-filter"},
    Word{"anti-aliasing", "technique/anti-aliasing/off"},
    Word{"jaggies", "technique/anti-aliasing/off"},
    Word{"transparency", "option/refraction"},
    Word{"bump map", "option/normal-mapping"},
    Word{"wireframe", "option/draw"},
    Word{"zoom", "fit"},
    Word{"full screen", "fullscreen"},
    Word{"soft shadows", "option/shadow-filter"},
    Word{"refraction", "option/refraction"},
    Word{"gamma", "option/gamma"},
    Word{"normals", "channel/normal"},
    Word{"z-fighting", "scene/lab/z-fighting"},
    Word{"perspective correct", "technique/perspective-correct/off"},
    Word{"fov", "option/viewport-fit"},
    Word{"msaa", "option/multisampling"},
    Word{"bias", "technique/shadow-epsilon/off"},
    Word{"peter-panning", "option/shadow-bias"},
    Word{"bvh", "option/accelerator"},
    Word{"fresnel", "option/transparency"},
    Word{"blinn", "option/highlight"},
    Word{"barycentric", "channel/barycentric"},
    Word{"overdraw", "channel/overdraw"},
    Word{"shading", "lesson/cgfs_13_shading"},
    Word{"scene shading", "scene/cgfs/shading"},
    Word{"far origin", "scene/lab/far-origin"},
    Word{"light", "lesson/cgfs_03_light"},
    Word{"texel", "option/texture-filter"},
    Word{"rotate camera", "orbit-left"},
    Word{"export png", "save-picture"},
    Word{"dark mode", "dark-theme"},
    Word{"compare image", "picture-b"},
    Word{"ray count", "study-timings"},
    Word{"heatmap", "channel/depth"},
    Word{"open obj", "open"},
    Word{"light position", "handles"},
    Word{"resolution", "size-own"},
    Word{"font size", "larger-type"},
    Word{"background", "save-scene"},
    Word{"screenshot", "shot-window"},
    Word{"share", "copy-permalink"},
    Word{"bundle", "save-bundle"},
    Word{"slides", "save-slide"},
    Word{"histogram", "difference"},
    Word{"help", "help"},
    Word{"notation", "scene-notation"},
    Word{"scene file", "scene-notation"},
    Word{"syntax", "scene-notation"},
    Word{"vertex numbers", "projected-vertices"},
    Word{"fps", "missing/frame rate"},
    Word{"depth of field", "missing/depth of field"},
    Word{"ambient occlusion", "missing/ambient occlusion"},
};

TEST(PaletteWords, LeadRight) {
  std::string commands = "wait idle\n";
  for (const Word& word : words)
    commands += std::string("key Ctrl+K\nwait frames 3\ntype \"") + word.typed +
                "\"\nwait frames 3\nprint palette/first\nkey Esc\nwait frames 2\n";
  const auto run = ps::test::play(commands, ps::fresh_output_folder("gui-palette-words"), "1366x768", "--size 160x120");
  ASSERT_EQ(run.status, 0) << run.errors;
  std::istringstream lines(run.output);
  std::string first;
  for (const Word& word : words) {
    std::getline(lines, first);
    EXPECT_EQ(first, word.first) << "typed: " << word.typed;
  }
}

// What this program does not have is named with the nearest that it has, and Enter goes there.
TEST(PaletteWords, NameTheNearestOfWhatIsNotHere) {
  const auto run = ps::test::play(
      "wait idle\nkey Ctrl+K\nwait frames 3\ntype \"bokeh\"\nwait frames 3\n"
      "expect \"palette/missing/depth of field\" contains \"No depth of field here\"\nkey Enter\nwait idle\n"
      "expect lesson cgfs_05_camera\n",
      ps::fresh_output_folder("gui-palette-nearest"), "1366x768", "--size 160x120");
  EXPECT_EQ(run.status, 0) << run.errors;
}

TEST(PaletteWords, AWholeWordComesBeforeAPartAndScatteredLettersLast) {
  EXPECT_EQ(palette_fit("Gamma", "gamma", ""), PaletteFit::is_label);
  EXPECT_EQ(palette_fit("msaa", "Drawing: Multisampling", "AA, MSAA, jaggies"), PaletteFit::is_word);
  EXPECT_EQ(palette_fit("draw", "Drawing: Multisampling", "AA, MSAA"), PaletteFit::begins_label);
  EXPECT_EQ(palette_fit("multi", "Drawing: Multisampling", "AA"), PaletteFit::in_label);
  EXPECT_EQ(palette_fit("sampling edges", "Drawing: Multisampling", "soft edges"), PaletteFit::has_words);
  EXPECT_EQ(palette_fit("dms", "Drawing: Multisampling", ""), PaletteFit::letters_in_order);
  EXPECT_EQ(palette_fit("msaa", "Slow motion: pictures as they are drawn, again", ""), std::nullopt);
}

// The pointer rests and nothing else happens: the tooltip comes into sight by itself, and goes with the next key.
TEST(Tooltip, ComesUnderARestingPointerAndGoesWithAKey) {
  const auto run = ps::test::play(
      "wait idle\nmove compare/split\nwait frames 3\nexpect window/tooltip off\nwait 1500\nexpect window/tooltip on\n"
      "key Down\nwait frames 3\nexpect window/tooltip off\nwait 900\nexpect window/tooltip off\n"
      "move compare/difference\nwait 1500\nexpect window/tooltip on\n",
      ps::fresh_output_folder("gui-tooltip"), "1366x768", "--size 160x120");
  EXPECT_EQ(run.status, 0) << run.errors;
}

// A tooltip at the right is within the window, however long it is and whatever came before it.
TEST(Tooltip, IsWithinTheWindow) {
  const auto run = ps::test::play(
      "wait idle\nmove compare/split\nwait 1500\nexpect window/tooltip on\nmove techniques/shading/flat\nwait 1500\n"
      "expect window/tooltip-end > 900\nexpect window/tooltip-end < 1230\nmove techniques/more\nwait 1500\n"
      "expect window/tooltip-end > 900\nexpect window/tooltip-end < 1230\n",
      ps::fresh_output_folder("gui-tooltip-end"), "1229x686", "--size 160x120");
  EXPECT_EQ(run.status, 0) << run.errors;
}

// Both pictures are rendered in the size that is asked for, and the picked pixel keeps its place in them.
TEST(PictureSize, IsSetInTheWindow) {
  const auto run = ps::test::play(
      "wait idle\nclick-pixel A 120,30\nwait idle\nkey Ctrl+K\nwait frames 3\ntype \"render at double\"\nwait frames "
      "3\n"
      "key Enter\nwait idle\nexpect a/size 320x240\nexpect b/size 320x240\nexpect pixel 240,60\nkey Ctrl+Z\n"
      "wait idle\nexpect a/size 160x120\nexpect pixel 120,30\n",
      ps::fresh_output_folder("gui-picture-size"), "1366x768", "--size 160x120");
  EXPECT_EQ(run.status, 0) << run.errors;
}

}  // namespace
}  // namespace palette_words_test
