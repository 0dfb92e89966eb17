// The presenter: pages end with a sentence, a question is asked with its choices and revealed by the key that reads on,
// the step's tool stands beside the pictures, and the window has the whole screen.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "engine/lesson.h"
#include "gui/program.h"
#include "support/golden.h"

namespace presenter_test {
namespace {

void expect_plays(const std::string& name, const std::string& commands, const std::string& lesson) {
  const auto run = ps::test::play("wait idle\n" + commands + "quit\n", ps::fresh_output_folder("gui-presenter-" + name),
                                  "1920x1080", "--lesson " + lesson);
  EXPECT_EQ(run.status, 0) << run.errors;
}

const std::string fits = "wait frames 4\nexpect window/cut \"\"\nexpect window/overlap \"\"\n";

TEST(Presenter, AsksWithChoicesAndRevealsByTheKeyThatReadsOn) {
  expect_plays(
      "question",
      "key F5\nwait idle\nexpect view/b/covered covered\nexpect caption/text contains \"A has shadows\"\n" + fits +
          "key PageDown\nwait idle\nexpect caption/text contains \"How many shadow rays\"\n"
          "expect caption/text contains \"1. None.\"\nexpect caption/text contains \"3. Two for each pixel\"\n"
          "expect view/b/covered covered\nexpect question/open on\n" +
          fits +
          "key PageDown\nwait idle\nexpect step 1\nexpect question/open off\n"
          "expect caption/text contains \"Right is: None.\"\nexpect caption/text contains \"set to none in B\"\n"
          // Hints come behind the answer, then the next step.
          "expect caption/text contains \"Look at the ground\"\nexpect view/b/picture B\n" +
          fits +
          "key PageDown\nwait idle\nexpect step 2\nexpect caption/text contains \"Each pixel has one eye ray\"\n",
      "tests/gui/files/questions");
}

TEST(Presenter, HasTheStepsToolBesideThePictures) {
  expect_plays("tool", "key F5\nwait idle\nexpect listing/values > 0\nexpect window/pictures-share > 14\n" + fits,
               "cgfs_02_basic_ray_tracing/11");
}

/// "LEFT,TOP RIGHT,BOTTOM", in window pixels.
struct Place {
  double left = 0, top = 0, right = 0, bottom = 0;
};
Place place_in(std::istream& lines) {
  Place place;
  char comma = 0;
  lines >> place.left >> comma >> place.top >> place.right >> comma >> place.bottom;
  return place;
}

TEST(Presenter, HasAFigureBesideThePictures) {
  const auto run =
      ps::test::play("wait idle\nkey F5\nwait idle\nkey PageDown\nwait idle\nkey PageDown\nwait idle\n"
                     "key PageDown\nwait idle\nprint area/pictures\nprint area/stage\n" +
                         fits + "expect figure contains \"the eye is beta\"\nquit\n",
                     ps::fresh_output_folder("gui-presenter-figure"), "1366x768", "--lesson cgfs_03_light/7");
  ASSERT_EQ(run.status, 0) << run.errors;
  std::istringstream lines(run.output);
  const Place pictures = place_in(lines), figure = place_in(lines);
  ASSERT_TRUE(lines) << run.output;
  EXPECT_LE(pictures.right, figure.left);
  EXPECT_GT(pictures.right - pictures.left, 400);
  EXPECT_GT(figure.right - figure.left, 400);
  EXPECT_GT(figure.bottom - figure.top, 400);
}

/// Whether it ends like a sentence, or as what comes before a list or a formula.
bool ends_as_a_sentence(const std::string& text) {
  constexpr std::string_view signs = ".?!:;\"')";
  return text.empty() || signs.find(text.back()) != std::string_view::npos;
}

// Formulas and figures have no full stop.
TEST(Presenter, PagesEndWithASentence) {
  const ps::Lesson lesson = ps::load_lesson("cgfs_12_hidden_surfaces");
  std::string commands = "key F5\nwait frames 4\nprint caption/text\n";
  for (int page = 0; page < 12; ++page) commands += "key PageDown\nwait frames 4\nprint caption/text\nprint step\n";
  const auto run =
      ps::test::play("draw off\nwait frames 4\n" + commands + "quit\n", ps::fresh_output_folder("gui-presenter-pages"),
                     "1920x1080", "--lesson cgfs_12_hidden_surfaces");
  ASSERT_EQ(run.status, 0) << run.errors;
  int sentences = 0;
  std::istringstream lines(run.output);
  std::string last;
  for (std::string line; std::getline(lines, line); last = line) {
    const bool step = !line.empty() && line.find_first_not_of("0123456789") == std::string::npos;
    if (!step) continue;
    EXPECT_TRUE(ends_as_a_sentence(last)) << last;
    ++sentences;
  }
  EXPECT_EQ(sentences, 12);
}

// A window of no size that was asked for has the screen while it presents, and no longer.
TEST(Presenter, HasTheWholeScreen) {
  const auto folder = ps::fresh_output_folder("gui-presenter-screen");
  std::ofstream(folder / "play.script") << "wait idle\nexpect window/fullscreen off\nkey F5\nwait idle\n"
                                           "expect window/fullscreen on\nkey Esc\nwait idle\n"
                                           "expect window/fullscreen off\nquit\n";
  const auto run = ps::test::run_window("--script " + (folder / "play.script").string() + " cgfs/spheres --size 60x60");
  EXPECT_EQ(run.status, 0) << run.errors;
}

}  // namespace
}  // namespace presenter_test
