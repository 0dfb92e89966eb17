// Where a step's text, its tool and pictures with their share do not fit, text and tool share one place: how one comes
// to the other, with the keyboard, by reading on and by a link, and what a new step shows.
#include <gtest/gtest.h>

#include "gui/program.h"
#include "support/golden.h"

namespace lesson_column_test {
namespace {

void expect_plays(const std::string& name, const std::string& commands, const std::string& arguments,
                  const std::string& size = "1024x768") {
  const auto run = ps::test::play("wait idle\n" + commands + "quit\n", ps::fresh_output_folder("gui-column-" + name),
                                  size, arguments);
  EXPECT_EQ(run.status, 0) << run.errors;
}

const std::string large = "--scale 1.5 --lesson ";
const std::string fits = "wait frames 4\nexpect window/cut \"\"\nexpect window/overlap \"\"\n";

TEST(LessonColumn, AKeyAndTabsChooseAndANewStepShowsItsText) {
  const std::string text = "wait frames 4\nexpect lesson/column text\nexpect column text\n",
                    tool = "wait frames 4\nexpect lesson/column tool\nexpect column tool\n";
  expect_plays("keys",
               text + fits + "key V\n" + tool + fits + "key V\n" + text + "click column/tool\n" + tool +
                   // Not a step of the history: what is undone is the step.
                   "key Shift+PageDown\nwait idle\n" + text + "key V\n" + tool + "key Ctrl+Z\nwait idle\n" + text +
                   // An answer's verdict is in the text.
                   "key Shift+PageDown\nwait idle\nclick column/tool\n" + tool + "click listing/line-41/pick\n" + fits +
                   "click question/answer\nwait idle\n" + text + "expect lesson/ask-again contains again\n" + fits,
               large + "cgfs_02_basic_ray_tracing/6");
}

// The line is clicked in the listing, which stands behind the task: a button leads there, and one leads back.
TEST(LessonColumn, AQuestionForALineLeadsToTheListingAndBack) {
  const std::string asks = " contains \"Click the wrong line\"\n",
                    text = "wait frames 2\nexpect lesson/column text\nexpect question/text" + asks + fits,
                    tool = "wait frames 2\nexpect lesson/column tool\nexpect status/hint" + asks + fits;
  for (const std::string size : {"1024x768", "1366x768"})
    expect_plays("bug-" + size,
                 text + "click question/turn\n" + tool + "click question/turn\n" + text + "click question/turn\n" +
                     tool + "click listing/line-41/pick\n" + tool + "expect question/answer \"Answer: line 41\"\n" +
                     "click question/turn\n" + text + "expect question/answer \"Answer: line 41\"\n" +
                     "click question/answer\nwait idle\nexpect lesson/column text\nexpect question/points 1\n" + fits,
                 large + "cgfs_02_basic_ray_tracing/7", size);
}

// Of the second one no line has values at the pixel, which is said above the code.
TEST(LessonColumn, AQuestionForALineLeavesTheListingItsLines) {
  for (const std::string size : {"1024x768", "1366x768"})
    for (const std::string step : {"cgfs_02_basic_ray_tracing/7", "cgfs_07_filled_triangles/8"})
      expect_plays("lines-" + size,
                   "click question/turn\nwait idle\nexpect listing/lines > 23\n" + fits +
                       "click listing/line-19/pick\nexpect listing/lines > 23\nexpect question/answer \"Answer: line "
                       "19\"\n" +
                       fits +
                       // Without the bug the question waits, in the same line.
                       "set listing-bug=none\nwait idle\nexpect listing/lines > 23\n"
                       "expect status/hint contains \"The question is about\"\n" +
                       fits +
                       "click question/back\nwait idle\nexpect listing/lines > 23\n"
                       "expect question/answer contains Answer\n" +
                       fits,
                   large + step, size);
}

TEST(LessonColumn, ReadingOnComesToTheToolBehindTheLastPage) {
  std::string pages;
  expect_plays(
      "reading",
      "click question/skip\nwait frames 6\nexpect lesson/pages 4\nexpect lesson/page 3\nkey PageDown\nwait frames "
      "4\nexpect lesson/page 4\nexpect lesson/column text\nkey PageDown\nwait frames 4\nexpect lesson/column "
      "tool\nkey PageUp\nwait frames 4\nexpect lesson/column text\nexpect lesson/page 4\nkey PageDown\nwait "
      "frames 4\nexpect lesson/column tool\nexpect step 3\nkey PageDown\nwait frames 4\nexpect "
      "step 4\nexpect lesson/column text\n",
      large + "study_speed_and_accuracy/3");
}

TEST(LessonColumn, AToolThatIsChosenIsShown) {
  expect_plays("chosen",
               "click question/skip\nwait frames 6\nchoose stage needs\nwait frames 4\nexpect lesson/column tool\n" +
                   fits +
                   // What belongs to the text is looked for there, what belongs to the tool is looked for here.
                   "click lesson/again\nwait frames 6\nexpect lesson/column text\nexpect stage chart\n"
                   "click chart/change\nwait frames 4\nexpect lesson/column tool\nkey Esc\n",
               large + "study_speed_and_accuracy/3");
}

// An experiment of the palette comes into sight, also where the step's own tool is the one that shows it.
TEST(LessonColumn, AnExperimentOfThePaletteIsShown) {
  expect_plays("palette",
               "expect lesson/column text\nkey Ctrl+K\nwait frames 3\ntype bvh-holes\nwait frames 3\nkey Enter\n"
               "wait frames 3\nexpect lesson/column tool\nexpect stability/shown bvh-holes\n",
               large + "cgfs_05_samples/4");
}

TEST(LessonColumn, TheListingsMenuHasWhatIsAboveTheCodeElsewhere) {
  expect_plays("menu",
               "key V\nwait idle\nclick listing/copy\nwait frames 6\nexpect own/open on\n" + fits +
                   "click listing/own/close\nwait idle\nexpect own/open off\nclick listing/picture\nwait idle\n" + fits,
               large + "cgfs_02_basic_ray_tracing/11");
}

TEST(LessonColumn, IsNotThereWhereAllHasRoom) {
  expect_plays("room", "expect lesson/column both\nexpect window/pictures-share > 14\n",
               "--lesson cgfs_02_basic_ray_tracing/11", "1366x768");
}

}  // namespace
}  // namespace lesson_column_test
