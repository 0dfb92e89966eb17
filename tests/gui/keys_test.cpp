// Keys: each has one meaning in every mode, and does what it says; what the mouse can do in the first look's offer and
// in trees, keys can do, too.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "gui/input/actions.h"
#include "gui/program.h"
#include "support/golden.h"

namespace ps::gui::keys_test {
namespace {

using Meanings = std::map<std::string, std::string>;  // names of actions by chord

Meanings meanings_of(const std::string& line) {
  Meanings meanings;
  std::istringstream words(line);
  for (std::string word; words >> word;) {
    const auto equals = word.rfind('=');  // a key may be an equals sign itself
    const std::string chord = word.substr(0, equals);
    EXPECT_TRUE(meanings.emplace(chord, word.substr(equals + 1)).second) << chord << " twice";
  }
  return meanings;
}

/// What opens something in front of the window, or leaves the mode that the walk is about.
bool leads_away(const std::string& action) {
  for (const std::string start : {"mode-",    "save-",   "shot-",     "lesson-",    "step-",   "focus-",     "open",
                                  "scenes",   "lessons", "quit",      "fullscreen", "palette", "help",       "kept",
                                  "glossary", "history", "picture-b", "reload",     "fly",     "slow-motion"})
    if (action.starts_with(start)) return true;
  return false;
}

TEST(Keys, HaveOneMeaningInEveryMode) {
  // The commands that lead to each state, in their order.
  const std::vector<std::pair<std::string, std::string>> states{{"explore", "click-pixel A 30,40\n"},
                                                                {"lesson without text", "key F2\n"},
                                                                {"lesson", "key ]\n"},
                                                                {"presenter", "key F5\n"},
                                                                {"study", "key F4\n"},
                                                                {"difference", "key F3\nkey D\n"},
                                                                {"flying", "key `\n"},
                                                                {"in the panels", "key Esc\nkey F6\n"}};
  std::string commands = "wait idle\n";
  for (const auto& [name, way] : states) commands += way + "wait idle\nprint keys/meanings\n";
  const auto result = test::play(commands + "quit\n", fresh_output_folder("gui-keys"), "1366x768", "--size 60x60");
  ASSERT_EQ(result.status, 0) << result.errors;
  std::istringstream lines(result.output);
  std::map<std::string, Meanings> by_state;
  for (const auto& [name, way] : states) {
    std::string line;
    ASSERT_TRUE(std::getline(lines, line)) << name;
    by_state[name] = meanings_of(line);
    EXPECT_GT(by_state[name].size(), 40u) << name;
    for (const auto& [chord, action] : by_state[name]) {
      EXPECT_EQ(action.find('+'), std::string::npos) << name << ": " << chord << " means " << action;
      EXPECT_NO_THROW(parse_chord(chord)) << chord;
    }
  }
  // From mode to mode a key means the same or nothing, but for those that a presenter's remote control has.
  std::map<std::string, std::set<std::string>> everywhere;
  for (const auto& [name, meanings] : by_state)
    if (name != "presenter")
      for (const auto& [chord, action] : meanings) everywhere[chord].insert(action);
  for (const auto& [chord, actions] : everywhere) EXPECT_EQ(actions.size(), 1u) << chord;
  EXPECT_EQ(by_state["presenter"]["."], "blank");
  EXPECT_EQ(by_state["explore"]["."], "story-forward");
  EXPECT_FALSE(by_state["explore"].contains("Enter")) << "there is no step to go to";
  EXPECT_EQ(by_state["lesson"]["Enter"], "step-next");
  EXPECT_FALSE(by_state["flying"].contains("D")) << "letters fly";
}

TEST(Keys, RunTheActionThatTheyMean) {
  const auto folder = fresh_output_folder("gui-keys-pressed");
  const std::string arguments = "--size 60x60", begin = "wait idle\nclick-pixel A 30,40\nwait idle\n";
  const auto known = test::play(begin + "print keys/meanings\nquit\n", folder, "1024x768", arguments);
  ASSERT_EQ(known.status, 0) << known.errors;
  std::string commands = begin;
  int walked = 0;
  for (const auto& [chord, action] : meanings_of(known.output.substr(0, known.output.find('\n')))) {
    if (leads_away(action)) continue;
    commands += "key \"" + chord + "\"\nexpect keys/last " + action + "\n";
    ++walked;
  }
  EXPECT_GT(walked, 45);
  const auto result = test::play(commands + "quit\n", folder, "1024x768", arguments);
  EXPECT_EQ(result.status, 0) << result.errors;
}

test::WindowRun start(const std::filesystem::path& folder, const std::string& commands) {
  std::ofstream(folder / "play.script") << "wait idle\n" << commands << "quit\n";
  return test::run_window("--script " + (folder / "play.script").string() + " --window-size 1024x768 --size 60x60",
                          "timeout 60 env XDG_STATE_HOME=" + folder.string());
}

TEST(Keys, AnswerTheFirstLooksOffer) {
  const std::string ring = "key F6\nwait frames 3\n", to_offer = ring + ring + ring;  // bar, techniques, offer
  const auto folder = std::filesystem::absolute(fresh_output_folder("gui-keys-offer"));
  std::filesystem::create_directories(folder / "pixelscope");
  auto run = start(folder, "expect first-look/offered on\n" + to_offer +
                               "expect keyboard/at first-look/start\nkey Right\nwait frames 3\n"
                               "expect keyboard/at first-look/not-now\nkey Left\nwait frames 3\nkey Enter\nwait idle\n"
                               "expect lesson a_first_look\nexpect first-look/offered off\n");
  EXPECT_EQ(run.status, 0) << run.errors;
  std::filesystem::remove_all(folder / "pixelscope");
  std::filesystem::create_directories(folder / "pixelscope");
  run = start(folder, to_offer + "key Tab\nwait frames 3\nkey Space\nwait idle\n"
                                 "expect lesson \"\"\nexpect first-look/offered off\n");
  EXPECT_EQ(run.status, 0) << run.errors;
}

TEST(Keys, GoThroughAPixelsTree) {
  const auto press = [](const std::string& key, int times) {
    std::string commands;
    for (int i = 0; i < times; ++i) commands += "key " + key + "\nwait frames 3\n";
    return commands;
  };
  // To the first event of the tree, whose children fold away and come back; Enter selects.
  const std::string commands =
      "wait idle\nclick-pixel A 30,40\nwait idle\nexpect selected-event -1\n" + press("Shift+F6", 2) + press("Tab", 7) +
      "expect keyboard/at pixel/a/event/0\n" + press("Enter", 1) + "wait idle\nexpect selected-event 0\n" +
      press("Left", 1) + press("Down", 1) + "expect-not keyboard/at pixel/a/event/1\n" + press("Up", 1) +
      "expect keyboard/at pixel/a/event/0\n" + press("Right", 1) + press("Down", 1) +
      "expect keyboard/at pixel/a/event/1\n" + press("Space", 1) + "wait idle\nexpect selected-event 1\n" +
      press("Esc", 1) + "expect keyboard/at \"\"\nquit\n";
  const auto result = test::play(commands, fresh_output_folder("gui-keys-tree"), "1366x768", "--size 60x60");
  EXPECT_EQ(result.status, 0) << result.errors;
}

}  // namespace
}  // namespace ps::gui::keys_test
