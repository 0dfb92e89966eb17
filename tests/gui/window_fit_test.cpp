// Nothing in the window is cut off or overlaps: in every mode and tool, and in every step of every lesson, at the sizes
// of old and new screens, with common and with large type.
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "engine/lesson.h"
#include "gui/program.h"
#include "support/golden.h"

namespace window_fit_test {
namespace {

struct FitScreen {
  std::string size, type;  ///< type: --scale
};

std::string name_of_screen(const testing::TestParamInfo<FitScreen>& info) {
  std::string name = info.param.size + "_type_" + info.param.type;
  for (char& c : name)
    if (c == '.') c = '_';
  return name;
}

struct FitPlace {
  std::string name;
  double least_share = 0;  ///< of the window, percent, that pictures have there
};

/// Plays the commands; each place where something does not fit is a failure.
void expect_all_fits(const std::string& commands, const std::vector<FitPlace>& places, const FitScreen& screen,
                     const std::string& arguments) {
  const auto folder = ps::fresh_output_folder("gui-fit-" + screen.size + "-" + screen.type);
  const auto result = ps::test::play(commands, folder, screen.size, "--scale " + screen.type + " " + arguments);
  ASSERT_EQ(result.status, 0) << result.errors;
  std::istringstream lines(result.output);
  for (const FitPlace& place : places) {
    std::string cut, overlap, share;
    ASSERT_TRUE(std::getline(lines, cut) && std::getline(lines, overlap) && std::getline(lines, share)) << place.name;
    EXPECT_EQ(cut, "") << "cut: " << place.name;
    EXPECT_EQ(overlap, "") << "overlap: " << place.name;
    EXPECT_GE(std::stod(share), place.least_share) << place.name;
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
  look_at("exploring with a pixel's story", "click-pixel A 20,30\n");
  for (const std::string tool :
       {"space", "microscope", "listing", "vertex", "pixels", "chart", "stability", "needs", "why", "timings"})
    look_at("drawer: " + tool, "click menu/study\nclick study-" + tool + "\n");
  look_at("study", "key F4\n");
  for (const std::string tool : {"pixels", "stability", "needs", "why", "timings"})
    look_at("study: " + tool, "click bottom/" + tool + "\n");
  look_at("list of lessons", "key F2\n");
  look_at("presenter", "key F5\n");
  look_at("split", "key Esc\nkey F3\nkey X\n");
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

TEST_P(WindowFit, NothingIsCutInAnyStepOfALesson) {
  // Pictures are waited for on four screens alone, of every fourth lesson each: it takes long. Otherwise a step is
  // looked at as soon as it is drawn.
  const std::vector<std::string> waiting{"1366x768 1", "1920x1080 1", "1366x768 1.5", "1920x1080 1.5"};
  const auto waited = std::find(waiting.begin(), waiting.end(), GetParam().size + " " + GetParam().type);
  std::string commands = "wait idle\n";
  std::vector<FitPlace> places;
  int number = 0;
  for (const std::string& name : ps::lesson_names()) {
    const bool waits = waited - waiting.begin() == number++ % std::ssize(waiting);
    const std::string wait = waits ? "wait idle\n" : "wait frames 4\n";
    const auto steps = ps::load_lesson(name).steps.size();
    for (std::size_t step = 0; step < steps; ++step) {
      if (step > 0 || !places.empty()) commands += (step == 0 ? "key ]\n" : "key Shift+PageDown\n") + wait;
      commands += "print window/cut\nprint window/overlap\nprint window/pictures-share\n";
      // Until its pictures come, a step shows those of the one before.
      places.push_back({name + ", step " + std::to_string(step + 1), waits ? 30.0 : 0.0});
    }
  }
  expect_all_fits(commands + "quit\n", places, GetParam(), "--lesson " + ps::lesson_names().front());
}

INSTANTIATE_TEST_SUITE_P(Screens, WindowFit,
                         testing::Values(FitScreen{"1024x768", "1"}, FitScreen{"1366x768", "1"},
                                         FitScreen{"1920x1080", "1"}, FitScreen{"3840x2160", "2"},
                                         FitScreen{"1024x768", "1.5"}, FitScreen{"1366x768", "1.5"},
                                         FitScreen{"1920x1080", "1.5"}, FitScreen{"3840x2160", "3"}),
                         name_of_screen);

}  // namespace
}  // namespace window_fit_test
