// A monkey at the window: random events through the queue of events for a bounded number of commands. Whatever they
// hit, the window answers, says nothing on standard error and ends in order. PIXELSCOPE_TEST_SEED repeats a run,
// PIXELSCOPE_MONKEY_COMMANDS lengthens it.
#include <gtest/gtest.h>

#include <unistd.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <random>

#include <fmt/format.h>

#include "gui/program.h"
#include "support/environment.h"
#include "support/golden.h"

namespace monkey_test {
namespace {

constexpr int width = 1024, height = 768;

class Monkey {
 public:
  explicit Monkey(unsigned seed) : random_(seed) {}

  /// One line of a script. No path is ever typed, so that no file outside the folder is named.
  std::string command() {
    switch (below(14)) {
    case 0:
    case 1:
    case 2:
      return fmt::format("move {0}\npress {1}\nlift {1}", place(), button());
    case 3:
      return fmt::format("move {}\nwait frames {}", place(), 1 + below(20));  // tooltips come up
    case 4:
      return fmt::format("drag {} {}{}", place(), place(), below(4) == 0 ? " right" : "");
    case 5:
      return fmt::format("wheel {}", below(9) - 4);
    case 6:
    case 7:
    case 8:
      return std::string("key ") + chord();
    case 9:
      return "key " + std::string(1, static_cast<char>('A' + below(26)));
    case 10:
      return "type " + word();
    case 11:
      return std::string("open ") + scene();
    case 12:
      return below(4) == 0 ? fmt::format("resize {}x{}", 640 + below(900), 480 + below(600)) : "key Esc";
    default:
      return fmt::format("move {}\nkey {}", place(), chord());
    }
  }

 private:
  int below(int end) { return std::uniform_int_distribution<int>(0, end - 1)(random_); }
  std::string place() { return fmt::format("{},{}", below(width), below(height)); }
  const char* button() {
    static constexpr std::array names{"left", "left", "left", "right", "middle"};
    return names[static_cast<std::size_t>(below(5))];
  }
  /// Keys that mean something here or there; none of them quits or saves.
  const char* chord() {
    static constexpr std::array chords{"Esc",      "Tab",       "Shift+Tab", "Enter",      "Space",  "Up",
                                       "Down",     "Left",      "Right",     "PageUp",     "Home",   "End",
                                       "PageDown", "F1",        "F2",        "F3",         "F4",     "F5",
                                       "F6",       "Ctrl+Z",    "Ctrl+Y",    "Ctrl+P",     "Ctrl+K", "Delete",
                                       "1",        "Backspace", "2",         "Shift+Left", "3",      "Shift+PageDown"};
    return chords[static_cast<std::size_t>(below(static_cast<int>(chords.size())))];
  }
  std::string word() {
    static constexpr std::array words{"gamma", "shadow", "0.5", "-1", "1e9", "nan", "teapot", "epsilon", "zzz", "12"};
    return words[static_cast<std::size_t>(below(static_cast<int>(words.size())))];
  }
  const char* scene() {
    static constexpr std::array scenes{"cgfs/reflections", "cgfs/crates", "cgfs/lens",   "lab/cornell",
                                       "cgfs/lines",       "no/such",     "cgfs/shadows"};
    return scenes[static_cast<std::size_t>(below(static_cast<int>(scenes.size())))];
  }

  std::mt19937 random_;
};

TEST(Monkey, RandomEventsLeaveTheWindowInOrder) {
  const unsigned seed = ps::test::test_seed();
  const int commands = static_cast<int>(ps::test::number_from("PIXELSCOPE_MONKEY_COMMANDS", 300));
  const auto folder = std::filesystem::absolute(ps::fresh_output_folder("gui-monkey"));
  Monkey monkey(seed);
  std::string script = "wait idle\n";
  for (int i = 0; i < commands; ++i) script += monkey.command() + "\n";
  script += "quit\n";
  const auto result = ps::test::play(script, folder, fmt::format("{}x{}", width, height), "cgfs/spheres --size 90x60");
  std::cout << "PIXELSCOPE_TEST_SEED=" << seed << ", script " << (folder / "script.script") << '\n';
  EXPECT_EQ(result.status, 0) << "PIXELSCOPE_TEST_SEED=" << seed << "\n" << result.errors << result.output;
  EXPECT_EQ(result.errors, "") << "PIXELSCOPE_TEST_SEED=" << seed;
}

}  // namespace
}  // namespace monkey_test
