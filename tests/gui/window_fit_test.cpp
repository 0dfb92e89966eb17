// Nothing in the window is cut off or overlaps: in every mode and tool, and in the lessons, at the sizes
// of old and new screens, with common and with large type.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <ostream>
#include <sstream>

#include "engine/lesson.h"
#include "gui/program.h"
#include "support/environment.h"
#include "support/golden.h"
#include "support/run_cli.h"
#include "support/trials.h"

namespace window_fit_test {
namespace {

struct FitScreen {
  std::string size, type;  ///< type: --scale
};

std::string name_of(const FitScreen& screen) {
  std::string name = screen.size + "_type_" + screen.type;
  for (char& c : name)
    if (c == '.') c = '_';
  return name;
}

/// How the name of a test shows it.
std::ostream& operator<<(std::ostream& out, const FitScreen& screen) { return out << name_of(screen); }

struct FitPlace {
  std::string name;
  double least_share = 0;  ///< of the window, percent, that pictures have there
  int page_counts = 0;     ///< how often the number of the text's pages is printed there
  int most_pages = 2;      ///< of a step's text, in common type
};

constexpr int most_pages = 3;  // of a step's text with its question, in common type

// After a key: one frame draws what follows from it, one knows the sizes of the regions in that, and one comes to rest.
// The player waits for two after the key.
const std::string settled = "wait frames 2\n";
const std::string print_fit = "print window/cut\nprint window/overlap\nprint window/pictures-share\n";

std::vector<FitScreen> fit_screens() {
  return {{"1024x768", "1"},   {"1366x768", "1"},   {"1920x1080", "1"},   {"3840x2160", "2"},
          {"1024x768", "1.5"}, {"1366x768", "1.5"}, {"1920x1080", "1.5"}, {"3840x2160", "3"}};
}

/// Plays the commands without drawing, which takes ten times as long as the layout that they are about; each place
/// where something does not fit is a failure.
void expect_all_fits(const std::string& commands, const std::vector<FitPlace>& places, const FitScreen& screen,
                     const std::string& arguments) {
  const auto folder = ps::fresh_output_folder("gui-fit");
  const auto result =
      ps::test::play("draw off\n" + commands, folder, screen.size, "--scale " + screen.type + " " + arguments);
  ASSERT_EQ(result.status, 0) << result.errors;
  std::istringstream lines(result.output);
  for (const FitPlace& place : places) {
    std::string cut, overlap, share;
    ASSERT_TRUE(std::getline(lines, cut) && std::getline(lines, overlap) && std::getline(lines, share)) << place.name;
    EXPECT_EQ(cut, "") << "cut: " << place.name;
    EXPECT_EQ(overlap, "") << "overlap: " << place.name;
    EXPECT_GE(std::stod(share), place.least_share) << place.name;
    for (int i = 0; i < place.page_counts; ++i) {
      std::string pages;
      ASSERT_TRUE(std::getline(lines, pages)) << place.name;
      EXPECT_LE(std::stoi(pages), place.most_pages) << place.name << (i == 0 ? "" : ", answered");
    }
  }
}

class WindowFit : public testing::TestWithParam<FitScreen> {};

TEST_P(WindowFit, NothingIsCutInAnyModeOrTool) {
  std::string commands = "wait idle\n";
  std::vector<FitPlace> places;
  const auto look_at = [&](const std::string& place, const std::string& way) {
    commands += way + "wait idle\n" + print_fit;
    places.push_back({place});
  };
  look_at("exploring", "");
  look_at("palette", "key Ctrl+K\nwait frames 2\ntype worst\nwait frames 2\n");
  look_at("exploring with a pixel's story", "key Esc\nclick-pixel A 20,30\n");
  for (const std::string tool :
       {"space", "microscope", "listing", "vertex", "pixels", "chart", "stability", "needs", "why", "timings"})
    look_at("drawer: " + tool, "click bottom/" + tool + "\n");
  look_at("study", "key F4\n");
  for (const std::string tool : {"pixels", "stability", "needs", "why", "timings"})
    look_at("study: " + tool, "click bottom/" + tool + "\n");
  look_at("list of lessons", "key F2\n");
  look_at("lessons found", "key Ctrl+L\nwait frames 3\ntype bresenham\nwait frames 3\n");
  look_at("presenter", "key Esc\nwait frames 3\nkey F5\n");
  look_at("presenter with slow motion", "key S\n");
  look_at("split", "key S\nkey Esc\nkey F3\nkey X\n");
  look_at("difference", "key D\n");
  look_at("difference in the presenter", "key F5\n");
  look_at("difference again", "key Esc\nkey F3\n");
  look_at("object with its gizmo", "key D\nkey T\nclick-pixel A 20,30\nwait idle\nclick options/object\n");
  look_at("false colours", "key N\n");
  look_at("presets and bookmarks", "key Shift+N\nkey M\nwait frames 3\nclick kept/preset-name\ntype mine\n"
                                   "click kept/keep-a\nclick kept/bookmark-name\n"
                                   "type \"a screen with a name that has no room beside its buttons in this window\"\n"
                                   "click kept/bookmark\nwait frames 3\n");
  look_at("history with its plots", "key Esc\nset exposure=2\nwait idle\nkey Y\n");
  look_at("all options below a lesson", "key Y\nkey ]\nwait idle\nkey F3\n");
  expect_all_fits(commands + "quit\n", places, GetParam(), "cgfs/shadows --size 60x60");
}

/// The menus, by the way to each.
const std::vector<std::vector<std::string>>& menus() {
  static const std::vector<std::vector<std::string>> all{{"menu/scene"},
                                                         {"menu/scene", "menu/recent"},
                                                         {"menu/lesson"},
                                                         {"menu"},
                                                         {"menu", "menu/view"},
                                                         {"menu", "menu/view", "menu/zoom"},
                                                         {"menu", "menu/view", "menu/pictures"},
                                                         {"menu", "menu/view", "menu/window"},
                                                         {"menu", "menu/view", "menu/type"},
                                                         {"menu", "menu/study"},
                                                         {"menu", "menu/help"}};
  return all;
}

// What a person sees at the very first start, which offers a lesson below the story.
TEST_P(WindowFit, TheOfferOfTheFirstStartIsSeenWhole) {
  const ps::test::ScratchFolder state;  // in which nothing is remembered yet
  const ps::test::Variable home("XDG_STATE_HOME", state.path().string());
  expect_all_fits("wait idle\nexpect first-look/offered on\n" + print_fit + "quit\n", {{"first start"}}, GetParam(),
                  "");
}

// A menu that is longer than the window would scroll, without a sign that there is more.
TEST_P(WindowFit, MenusAreSeenWhole) {
  std::string commands = "wait idle\nopen cgfs/reflections\nwait idle\n";
  std::vector<FitPlace> places;
  const std::string look = settled + print_fit;
  for (const std::vector<std::string>& way : menus()) {
    for (const std::string& menu : way) commands += "click " + menu + "\n" + settled;
    commands += look;
    places.push_back({way.back()});
    for (std::size_t i = 0; i <= way.size(); ++i) commands += "key Esc\n";
    commands += settled;
  }
  expect_all_fits(commands + "quit\n", places, GetParam(), "cgfs/shadows --size 60x60");
}

INSTANTIATE_TEST_SUITE_P(Screens, WindowFit, testing::ValuesIn(fit_screens()),
                         [](const testing::TestParamInfo<FitScreen>& each) { return name_of(each.param); });

// What is not drawn is laid out all the same: what is cut is found, here in a window that becomes too small for its
// type.
TEST(FitWithoutDrawing, FindsWhatIsCut) {
  const auto folder = ps::fresh_output_folder("gui-fit-undrawn");
  const std::string commands =
      "wait idle\nprint window/cut\nresize 800x600\nwait idle\nprint window/cut\nprint window/overlap\nquit\n";
  const std::string arguments = "cgfs/shadows --size 60x60 --scale 3";
  const auto drawn = ps::test::play("draw on\n" + commands, folder, "3840x2160", arguments),
             undrawn = ps::test::play("draw off\n" + commands, folder, "3840x2160", arguments);
  ASSERT_EQ(undrawn.status, 0) << undrawn.errors;
  EXPECT_EQ(undrawn.output, drawn.output);
  EXPECT_EQ(undrawn.output.find('\n'), 0u) << "something is cut in the large window: " << undrawn.output;
  EXPECT_NE(undrawn.output.find("menu/"), std::string::npos) << undrawn.output;
}

/// A screen and a share of the lessons, which lie together in the course.
struct LessonScreen {
  FitScreen screen;
  std::size_t share = 0, shares = 1;
};

std::string name_of(const LessonScreen& lessons) {
  return name_of(lessons.screen) + "_share_" + std::to_string(lessons.share);
}
std::ostream& operator<<(std::ostream& out, const LessonScreen& lessons) { return out << name_of(lessons); }

/// All lessons on each screen.
std::vector<LessonScreen> lesson_screens() {
  std::vector<LessonScreen> all;
  for (const FitScreen& screen : fit_screens())
    for (std::size_t share = 0; share < 2; ++share) all.push_back({screen, share, 2});
  return all;
}

/// All lessons once, since pictures take long: every second share on either of the screens with little room.
std::vector<LessonScreen> lesson_pictures() {
  std::vector<LessonScreen> all;
  for (std::size_t share = 0; share < 24; ++share)
    all.push_back({{share % 2 == 0 ? "1024x768" : "1366x768", "1"}, share, 24});
  return all;
}

/// Prints how many pages a step's text has, and again with the hints and claims that come after an answer. Returns how
/// often it does.
int print_pages(const ps::LessonStep& step, std::string& commands) {
  const std::string print = "print lesson/pages\n";
  commands += print;
  if (!step.question) return 1;
  const std::string asked = step.question->kind == ps::AskKind::pixel ? "predict" : "question";
  commands += "click " + asked + "/skip\n" + settled + print;
  return 2;
}

/// Looks at a step, and what is to be looked at there.
using LookAtStep = std::function<void(const ps::LessonStep& step, const std::string& name, std::string& commands,
                                      std::vector<FitPlace>& places)>;

/// Goes through all steps of the share's lessons.
void expect_steps_fit(const LessonScreen& lessons, const LookAtStep& look) {
  const auto& [screen, share, shares] = lessons;
  const std::vector<std::string>& names = ps::lesson_names();
  const auto begin = names.size() * share / shares, end = names.size() * (share + 1) / shares;
  std::string commands = settled;
  std::vector<FitPlace> places;
  for (auto lesson = begin; lesson < end; ++lesson) {
    const ps::Lesson read = ps::load_lesson(names[lesson]);
    for (std::size_t step = 0; step < read.steps.size(); ++step) {
      if (!places.empty()) commands += step == 0 ? "key ]\n" : "key Shift+PageDown\n";
      look(read.steps[step], names[lesson] + ", step " + std::to_string(step + 1), commands, places);
    }
  }
  expect_all_fits(commands + "quit\n", places, screen, "--lesson " + names[begin]);
}

class LessonFit : public testing::TestWithParam<LessonScreen> {};

// A step is looked at as soon as it is laid out, while its pictures are those of the step before.
TEST_P(LessonFit, NothingIsCut) {
  const FitScreen& screen = GetParam().screen;
  expect_steps_fit(GetParam(), [&](const ps::LessonStep& step, const std::string& name, std::string& commands,
                                   std::vector<FitPlace>& places) {
    commands += settled + print_fit;
    FitPlace& place = places.emplace_back(FitPlace{name});
    if (screen.type == "1") place.page_counts = print_pages(step, commands);
    const bool drawn = std::any_of(step.blocks.begin(), step.blocks.end(),
                                   [](const ps::TextBlock& block) { return block.figure != nullptr; });
    if (drawn) ++place.most_pages;  // a figure takes the room of a third of a page or more
    // So do the three tests of a routine to write, and what was wrong about the answers that were not given.
    if (step.question || !step.write.empty()) ++place.most_pages;
    // Where there is no room for both the step's tool is behind its text; elsewhere the key does nothing.
    commands += "key V\n" + settled + print_fit;
    places.push_back({name + ", its tool"});
  });
}

INSTANTIATE_TEST_SUITE_P(Screens, LessonFit, testing::ValuesIn(lesson_screens()),
                         [](const testing::TestParamInfo<LessonScreen>& each) { return name_of(each.param); });

class LessonPictures : public testing::TestWithParam<LessonScreen> {};

// The same with the pictures, their captions and what was measured for the step.
TEST_P(LessonPictures, HaveTheirShareAndNothingIsCut) {
  // A screen of 1024 columns has room for the text and one picture; its columns do not follow a picture's shape.
  const bool small = GetParam().screen.size == "1024x768";
  expect_steps_fit(GetParam(), [small](const ps::LessonStep& step, const std::string& name, std::string& commands,
                                       std::vector<FitPlace>& places) {
    const std::string* compare = ps::part_of(step.state, "compare");
    // A square picture alone is as high as there is room, which leaves more beside it on a wide screen.
    const bool tool = !step.state.stage.empty() && step.state.stage != ps::pictures_stage;
    const bool alone = compare && compare->starts_with("only");
    const double least = tool ? (small ? 11.5 : 13.5) : alone ? (small ? 16 : 25) : (small ? 29 : 30);
    // The answer to a question and an experiment take seconds to measure, and minutes under a sanitizer.
    const bool measures = ps::test::trial_divisor > 1 && (step.question || ps::part_of(step.state, "experiment"));
    commands += measures ? settled + "wait until a/state done\nwait until b/state done\n" + settled : "wait idle\n";
    commands += print_fit;
    places.push_back({name, least});
  });
}

INSTANTIATE_TEST_SUITE_P(Screens, LessonPictures, testing::ValuesIn(lesson_pictures()),
                         [](const testing::TestParamInfo<LessonScreen>& each) { return name_of(each.param); });

}  // namespace
}  // namespace window_fit_test
