// Nothing in the window is cut off or overlaps: in every mode and tool, and in the lessons, at the sizes
// of old and new screens, with common and with large type.
#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>
#include <sstream>

#include "engine/lesson.h"
#include "gui/program.h"
#include "support/environment.h"
#include "support/golden.h"
#include "support/run_cli.h"

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
};

constexpr int most_pages = 2;  // of a step's text, in common type

/// Plays the commands; each place where something does not fit is a failure.
void expect_all_fits(const std::string& commands, const std::vector<FitPlace>& places, const FitScreen& screen,
                     const std::string& arguments) {
  // One folder for each test: several of one screen run at a time.
  std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
  std::replace(name.begin(), name.end(), '/', '-');
  const auto folder = ps::fresh_output_folder("gui-fit-" + name);
  const auto result = ps::test::play(commands, folder, screen.size, "--scale " + screen.type + " " + arguments);
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
      EXPECT_LE(std::stoi(pages), most_pages) << place.name << (i == 0 ? "" : ", answered");
    }
  }
}

class WindowFit : public testing::TestWithParam<FitScreen> {};

TEST_P(WindowFit, NothingIsCutInAnyModeOrTool) {
  std::string commands = "wait idle\n";
  std::vector<FitPlace> places;
  const auto look_at = [&](const std::string& place, const std::string& way) {
    commands += way + "wait idle\nprint window/cut\nprint window/overlap\nprint window/pictures-share\n";
    places.push_back({place});
  };
  look_at("exploring", "");
  look_at("palette", "key Ctrl+K\nwait frames 4\ntype worst\nwait frames 4\n");
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

/// The menus, each with those that open beside it.
struct OpenMenu {
  std::string name;
  std::vector<std::string> beside;
};

const std::vector<OpenMenu>& menus() {
  static const std::vector<OpenMenu> all{{"scene", {"recent"}},
                                         {"lesson", {}},
                                         {"view", {"zoom", "pictures", "window", "type"}},
                                         {"study", {}},
                                         {"help", {}}};
  return all;
}

// What a person sees at the very first start, which offers a lesson above the options.
TEST_P(WindowFit, TheOfferOfTheFirstStartIsSeenWhole) {
  const ps::test::ScratchFolder state;  // in which nothing is remembered yet
  const ps::test::Variable home("XDG_STATE_HOME", state.path().string());
  const std::string look = "print window/cut\nprint window/overlap\nprint window/pictures-share\n";
  expect_all_fits("wait idle\nexpect first-look/offered on\n" + look + "quit\n", {{"first start"}}, GetParam(), "");
}

// A menu that is longer than the window would scroll, without a sign that there is more.
TEST_P(WindowFit, MenusAreSeenWhole) {
  const auto& [size, type] = GetParam();
  if (size == "3840x2160" || (size == "1920x1080" && type != "1")) GTEST_SKIP() << "more room than on 1366x768";
  std::string commands = "wait idle\nopen cgfs/reflections\nwait idle\n";
  std::vector<FitPlace> places;
  const std::string look = "wait frames 4\nprint window/cut\nprint window/overlap\nprint window/pictures-share\n";
  for (const OpenMenu& menu : menus()) {
    commands += "click menu/" + menu.name + "\n" + look;
    places.push_back({"menu: " + menu.name});
    const std::string close = "key Esc\nkey Esc\nwait frames 4\n";
    for (const std::string& beside : menu.beside) {  // one may lie over the menu
      commands += close + "click menu/" + menu.name + "\nwait frames 4\nclick menu/" + beside + "\n" + look;
      places.push_back({"menu: " + menu.name + ", " + beside});
    }
    commands += close;
  }
  expect_all_fits(commands + "quit\n", places, GetParam(), "cgfs/shadows --size 60x60");
}

INSTANTIATE_TEST_SUITE_P(Screens, WindowFit,
                         testing::Values(FitScreen{"1024x768", "1"}, FitScreen{"1366x768", "1"},
                                         FitScreen{"1920x1080", "1"}, FitScreen{"3840x2160", "2"},
                                         FitScreen{"1024x768", "1.5"}, FitScreen{"1366x768", "1.5"},
                                         FitScreen{"1920x1080", "1.5"}, FitScreen{"3840x2160", "3"}),
                         [](const testing::TestParamInfo<FitScreen>& each) { return name_of(each.param); });

/// A screen and a share of the lessons, which lie together in the course.
struct LessonScreen {
  FitScreen screen;
  std::size_t share = 0, shares = 1;
  enum class Steps { first, all } steps = Steps::first;
};

std::string name_of(const LessonScreen& lessons) {
  return name_of(lessons.screen) + "_share_" + std::to_string(lessons.share);
}
std::ostream& operator<<(std::ostream& out, const LessonScreen& lessons) { return out << name_of(lessons); }

std::vector<LessonScreen> lesson_screens() {
  // Every step where there is least room; the first of each lesson on larger screens.
  std::vector<LessonScreen> all;
  for (const FitScreen& screen : {FitScreen{"1024x768", "1"}, FitScreen{"1366x768", "1"}, FitScreen{"1024x768", "1.5"}})
    for (std::size_t share = 0; share < 11; ++share) all.push_back({screen, share, 11, LessonScreen::Steps::all});
  for (const FitScreen& screen :
       {FitScreen{"1920x1080", "1"}, FitScreen{"3840x2160", "2"}, FitScreen{"1366x768", "1.5"},
        FitScreen{"1920x1080", "1.5"}, FitScreen{"3840x2160", "3"}})
    all.push_back({screen});
  return all;
}

/// Prints how many pages a step's text has, and again with the hints and claims that come after an answer. Returns how
/// often it does.
int print_pages(const ps::LessonStep& step, std::string& commands) {
  const std::string print = "print lesson/pages\n";
  commands += print;
  if (!step.question) return 1;
  const std::string asked = step.question->kind == ps::AskKind::pixel ? "predict" : "question";
  commands += "click " + asked + "/skip\nwait frames 4\n" + print;
  return 2;
}

class LessonFit : public testing::TestWithParam<LessonScreen> {};

TEST_P(LessonFit, NothingIsCut) {
  const auto& [screen, share, shares, extent] = GetParam();
  // Pictures are waited for on two screens alone, of every second share each: it takes long. Otherwise a step is looked
  // at as soon as it is drawn.
  const bool waits = screen.type == "1" && share % 2 == (screen.size == "1024x768" ? 0 : 1);
  const std::vector<std::string>& names = ps::lesson_names();
  const auto begin = names.size() * share / shares, end = names.size() * (share + 1) / shares;
  std::string commands;
  std::vector<FitPlace> places;
  for (auto lesson = begin; lesson < end; ++lesson) {
    const ps::Lesson read = ps::load_lesson(names[lesson]);
    const auto steps = extent == LessonScreen::Steps::all ? read.steps.size() : 1;
    for (std::size_t step = 0; step < steps; ++step) {
      const std::string* compare = ps::part_of(read.steps[step].state, "compare");
      // A square picture alone is as high as there is room, which leaves more beside it on a wide screen.
      const double least = compare && compare->starts_with("only") ? 25 : 30;
      if (!places.empty()) commands += step == 0 ? "key ]\n" : "key Shift+PageDown\n";
      commands += waits || places.empty() ? "wait idle\n" : "wait frames 4\n";
      commands += "print window/cut\nprint window/overlap\nprint window/pictures-share\n";
      // Until its pictures come, a step shows those of the one before.
      FitPlace& place =
          places.emplace_back(FitPlace{names[lesson] + ", step " + std::to_string(step + 1), waits ? least : 0.0});
      if (extent == LessonScreen::Steps::all && screen.type == "1")
        place.page_counts = print_pages(read.steps[step], commands);
      // In large type the step's tool is behind its text.
      if (extent != LessonScreen::Steps::all || screen.type == "1" || !ps::part_of(read.steps[step].state, "stage"))
        continue;
      commands += "key V\nwait frames 4\nprint window/cut\nprint window/overlap\nprint window/pictures-share\n";
      places.push_back({names[lesson] + ", step " + std::to_string(step + 1) + ", its tool"});
    }
  }
  expect_all_fits(commands + "quit\n", places, screen, "--lesson " + names[begin]);
}

INSTANTIATE_TEST_SUITE_P(Screens, LessonFit, testing::ValuesIn(lesson_screens()),
                         [](const testing::TestParamInfo<LessonScreen>& each) { return name_of(each.param); });

}  // namespace
}  // namespace window_fit_test
