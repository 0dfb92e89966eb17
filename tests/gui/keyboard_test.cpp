// Real keys of keyboards that are not American, pressed by xdotool: letters and signs are what is typed, digits and the
// keys that fly are places.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

#include "gui/program.h"
#include "support/golden.h"

namespace ps::gui::keyboard_test {
namespace {

bool have_tools() {
  return std::system("command -v xdotool >/dev/null 2>&1 && command -v setxkbmap >/dev/null 2>&1") == 0;
}

/// Some keys, and what the window says then.
struct Step {
  std::string hand;    ///< shell commands
  std::string expect;  ///< a condition of scripts; empty: the window has closed
};

const std::string keys = "xdotool key ";

/// Takes the steps in a window that starts with a keyboard of that layout.
void press(const std::string& name, const std::string& layout, const std::vector<Step>& steps) {
  const auto folder = std::filesystem::absolute(fresh_output_folder("gui-keyboard-" + name));
  std::string script = "wait idle\nprint window/size\n";
  std::string hand = "said() { for i in $(seq 400); do [ \"$(wc -l <" + (folder / "output").string() +
                     ")\" -ge $1 ] && return; sleep 0.05; done; exit 1; }\n"
                     "xdotool windowfocus $window || true\nxdotool mousemove --window $window 5 300\n";
  int line = 1;
  for (const Step& step : steps) {
    script +=
        step.expect.empty() ? "wait until window/turns < 0\n" : "wait until " + step.expect + "\nprint window/size\n";
    hand += step.hand + "\n" + (step.expect.empty() ? "" : "said " + std::to_string(++line) + "\n");
  }
  // Something must hold the display while setxkbmap runs, which would be made new at its end.
  const std::string before =
      "sh -c 'xdotool sleep 60 & holds=$!; setxkbmap " + layout + "; \"$@\"; status=$?; kill $holds; exit $status' sh";
  const auto result = test::play_by_hand(script, hand, folder, "cgfs/spheres --size 64x64", before);
  EXPECT_EQ(result.status, 0) << result.errors;
  EXPECT_EQ(result.errors, "");
}

TEST(Keyboard, GermanLettersAndSigns) {
  if (!have_tools()) GTEST_SKIP() << "xdotool and setxkbmap are not installed";
  press("de", "de",
        {{keys + "y", "keys/last history"},
         {keys + "z", "keys/last loupe"},
         {keys + "n", "keys/last channel-next"},
         {keys + "ctrl+z", "keys/last undo"},
         {keys + "ctrl+y", "keys/last redo"},
         {keys + "plus", "keys/last zoom-in"},
         {keys + "minus", "keys/last zoom-out"},
         {keys + "bracketright", "keys/last lesson-after"},
         {keys + "question", "help/open on"},
         {keys + "Escape", "help/open off"},
         {"setxkbmap us; " + keys + "grave", "flying on"},
         {keys + "29", "keys/last history"}});  // the place that typed z
}

TEST(Keyboard, FrenchLettersInATextField) {
  if (!have_tools()) GTEST_SKIP() << "xdotool and setxkbmap are not installed";
  press("fr", "fr",
        {{keys + "ctrl+k", "palette/open on"},
         {keys + "b; " + keys + "b", "palette/text bb"},
         {keys + "ctrl+a; " + keys + "z", "palette/text z"},
         {keys + "ctrl+a ctrl+x", "palette/text \"\""},
         {keys + "ctrl+v", "palette/text z"},
         {keys + "Escape", "palette/open off"},
         {keys + "ampersand", "keys/last one-to-one"},
         {keys + "agrave", "keys/last fit"},
         {keys + "minus", "keys/last zoom-out"},
         {keys + "question", "help/open on"},
         {keys + "Escape", "help/open off"},
         {keys + "grave", "flying on"},
         {"xdotool keydown z", "camera/position/z > 0.2"},
         {"xdotool keyup z; xdotool keydown q", "camera/position/x < -0.2"},
         {"xdotool keyup q", "flying on"},
         {keys + "Escape", "flying off"},
         {keys + "ctrl+q", ""}});
}

TEST(Keyboard, RussianPlaces) {
  if (!have_tools()) GTEST_SKIP() << "xdotool and setxkbmap are not installed";
  press("ru", "ru",
        {{keys + "29", "keys/last history"},
         {keys + "57", "keys/last channel-next"},
         {keys + "ctrl+52", "keys/last undo"},
         {keys + "ctrl+45", "palette/open on"},
         {"setxkbmap fr; " + keys + "b; " + keys + "b; setxkbmap ru; " + keys + "ctrl+38; setxkbmap us; " + keys + "z",
          "palette/text z"}});
}

}  // namespace
}  // namespace ps::gui::keyboard_test
