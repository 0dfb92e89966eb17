// A tool that a step names has room at 1366x768, in every step of every lesson; a story that no step names is one line.
// The columns of text have two widths, and a click right after the page has changed does not count.
#include <gtest/gtest.h>

#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <vector>

#include "engine/lesson.h"
#include "gui/program.h"
#include "support/golden.h"

namespace lesson_stage_test {
namespace {

const std::string screen = "1366x768";

/// Lines that the commands print. Nothing is drawn: they are about the layout.
std::vector<std::string> printed(const std::string& commands, const std::string& name, const std::string& lesson) {
  const auto result = ps::test::play("draw off\nwait frames 3\n" + commands + "quit\n", ps::fresh_output_folder(name),
                                     screen, "--lesson " + lesson);
  EXPECT_EQ(result.status, 0) << result.errors;
  std::istringstream lines(result.output);
  std::vector<std::string> all;
  for (std::string line; std::getline(lines, line);) all.push_back(line);
  return all;
}

struct Place {
  std::string name, stage;
};

/// "800 260"
bool is_room(const std::string& printed) {
  std::istringstream words(printed);
  double width = 0, height = 0;
  words >> width >> height;
  return (width >= 800 && height >= 260) || (width >= 590 && height >= 600);
}

/// Steps of the mode lesson that name a tool.
bool names_tool(const ps::LessonStep& step) {
  const std::string& stage = step.state.stage;
  return step.state.mode == ps::ScreenMode::lesson && !stage.empty() && stage != ps::pictures_stage;
}

/// The column of a step's text from "LEFT,TOP RIGHT,BOTTOM".
int width_of(const std::string& area) {
  double left = 0, right = 0;
  char comma = 0;
  double top = 0;
  std::istringstream(area) >> left >> comma >> top >> right;
  return static_cast<int>(right - left);
}

// One window walks through all of the course, without waiting for its pictures.
TEST(LessonStage, EveryStepsToolHasRoomAndTheTextTwoWidths) {
  std::string commands;
  std::vector<Place> places;
  for (const std::string& name : ps::lesson_names()) {
    const ps::Lesson lesson = ps::load_lesson(name);
    for (std::size_t step = 0; step < lesson.steps.size(); ++step) {
      if (!places.empty()) commands += step == 0 ? "key ]\n" : "key Shift+PageDown\n";
      commands += "wait frames 2\nprint area/lesson\n";
      if (names_tool(lesson.steps[step])) commands += "print tool/room\n";
      places.push_back({name + ", step " + std::to_string(step + 1),
                        names_tool(lesson.steps[step]) ? lesson.steps[step].state.stage : ""});
    }
  }
  const auto lines = printed(commands, "gui-stage-rooms", ps::lesson_names().front());
  std::map<int, std::string> widths;
  auto line = lines.begin();
  for (const auto& [name, stage] : places) {
    ASSERT_GE(lines.end() - line, stage.empty() ? 1 : 2) << name;
    widths.emplace(width_of(*line++), name);
    if (stage.empty()) continue;
    EXPECT_TRUE(is_room(*line)) << name << ": " << stage << " has " << *line;
    ++line;
  }
  std::string found;
  for (const auto& [width, name] : widths) found += std::to_string(width) + " in " + name + "\n";
  EXPECT_LE(widths.size(), 2u) << found;
}

// The same for the first step with each tool, with all that its toolbar has once the story and the results are there.
TEST(LessonStage, ItsToolbarLeavesTheToolItsRoom) {
  std::set<std::string> seen;
  for (const std::string& name : ps::lesson_names()) {
    const ps::Lesson lesson = ps::load_lesson(name);
    for (std::size_t step = 0; step < lesson.steps.size(); ++step) {
      const std::string& stage = lesson.steps[step].state.stage;
      if (!names_tool(lesson.steps[step]) || lesson.steps[step].question || !seen.insert(stage).second) continue;
      const std::string place = name + "/" + std::to_string(step + 1);
      const auto lines = printed("wait idle\nprint tool/room\n", "gui-stage-toolbar", place);
      ASSERT_EQ(lines.size(), 1u) << place;
      EXPECT_TRUE(is_room(lines.front())) << place << ": " << stage << " has " << lines.front();
    }
  }
  EXPECT_GE(seen.size(), 6u);
}

TEST(LessonStage, AStepWhoseTextNamesAToolHasItsLine) {
  const std::regex tool(R"(\b(the|its|their) stor(y|ies)\b|\bspace view\b|\bmicroscope\b)"
                        R"(|\bpanel (vertex|listing|timings|chart|stability|needs|pixels|why)\b)",
                        std::regex::icase);
  for (const std::string& name : ps::lesson_names()) {
    const ps::Lesson lesson = ps::load_lesson(name);
    for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
      const ps::LessonStep& step = lesson.steps[i];
      if (step.state.mode != ps::ScreenMode::lesson || !step.state.stage.empty()) continue;
      for (const auto* blocks : {&step.blocks, &step.hints})
        for (const ps::TextBlock& block : *blocks) {
          const std::string text = ps::plain_text(block);
          EXPECT_FALSE(std::regex_search(text, tool)) << name << ", step " << i + 1 << ": " << text;
        }
    }
  }
}

void expect_plays(const std::string& name, const std::string& commands, const std::string& lesson) {
  const auto run = ps::test::play("wait idle\n" + commands + "quit\n", ps::fresh_output_folder("gui-stage-" + name),
                                  screen, "--lesson " + lesson);
  EXPECT_EQ(run.status, 0) << run.errors;
}

TEST(LessonStage, TheFoldedStoryOpensOnAClick) {
  expect_plays("fold",
               "expect stage/open contains ›\nclick stage/open\nwait idle\nexpect stage story\n"
               "expect window/pictures-share > 14\nchoose stage verdict\nwait frames 4\nexpect stage/open contains ›\n"
               "expect window/pictures-share > 30\n",
               "cgfs_03_light/1");
}

// 0.4 and 0.6 seconds after the change, by a clock that the script holds.
TEST(LessonStage, AClickRightAfterAChangeDoesNotCount) {
  expect_plays("hasty",
               "clock 10\nkey Shift+PageDown\nwait frames 4\nexpect step 2\n"
               "clock 10.4\nclick question/skip\nwait frames 4\nexpect question/open on\n"
               "click lesson/next\nwait frames 4\nexpect step 2\n"
               "clock 10.6\nclick lesson/next\nwait frames 4\nexpect step 3\n"
               "clock 11\nclick question/skip\nwait frames 4\nexpect question/open on\n"
               "clock 11.2\nclick question/skip\nwait frames 4\nexpect question/open off\n",
               "tests/gui/files/questions");
}

// The one who skips is told the answer, and why it is right.
TEST(LessonStage, SkipTellsTheAnswerAndItsReason) {
  const auto skipped = [](const std::string& control, const std::string& answer, const std::string& reason) {
    return "click " + control + "/skip\nwait idle\nexpect question/verdict contains skipped\n" +
           "expect question/verdict contains \"" + answer + "\"\n" + "expect question/verdict contains \"" + reason +
           "\"\nkey Shift+PageDown\nwait idle\n";
  };
  expect_plays("skip",
               skipped("question", "Right is: None.", "set to none in B") +
                   skipped("question", "It is 57,600 rays.", "240 columns and 240 rows") +
                   skipped("question", "is such a place", "It lies in the middle") +
                   skipped("predict", "It is 3 rays", "skipped"),
               "tests/gui/files/questions");
}

}  // namespace
}  // namespace lesson_stage_test
