#include <gtest/gtest.h>

#include <set>
#include <utility>

#include "base/check.h"
#include "gui/input/actions.h"
#include "gui/platform/events.h"

namespace actions_test {
namespace {

using namespace ps::gui;

TEST(Chord, TextReadsBack) {
  for (const char* text : {"Ctrl+Shift+Z", "?", "F11", "PageDown", "[", "`", "Ctrl++", "Ctrl+-", "Ctrl+=", "Space",
                           "Shift+N", "Ctrl+Left", "0", ",", "Alt+Enter", "Esc"})
    EXPECT_EQ(chord_text(parse_chord(text)), text);
  EXPECT_EQ(parse_chord("?"), parse_chord("Shift+/"));
  for (const char* text : {"", "Ctrl+", "Hyper+A", "F13", "AB", "Ctrl"})
    EXPECT_THROW(parse_chord(text), ps::InputError);
}

// Each key that can be bound reaches the program: as the system numbers it, and back.
TEST(Chord, EveryKeyIsTheSystemsKeyAndBack) {
  std::set<int> numbers;
  for (Key key = key_after(Key::none, 1); key != Key::other; key = key_after(key, 1)) {
    if (key == Key::question || key == Key::plus) continue;  // typed, but by no key of their own
    const int number = scancode_of(key);
    EXPECT_NE(number, 0) << static_cast<int>(key);
    EXPECT_EQ(key_of(number), key) << number;
    EXPECT_TRUE(numbers.insert(number).second) << "two keys are " << number;
    if (key >= Key::ctrl) continue;  // no chord without another key
    const std::string name = chord_text({.key = key});
    EXPECT_EQ(parse_chord(name), Chord{.key = key}) << name;
  }
  EXPECT_EQ(key_of(0), Key::other);
  EXPECT_EQ(key_of(511), Key::other);
  // The places of keys in the Universal Serial Bus's tables, which the window library uses.
  constexpr std::pair<Key, int> usb[] = {{Key::a, 4},        {Key::z, 29},     {Key::digit_1, 30},
                                         {Key::digit_0, 39}, {Key::enter, 40}, {Key::f1, 58},
                                         {Key::f12, 69},     {Key::left, 80},  {Key::slash, 56}};
  for (const auto& [key, number] : usb) EXPECT_EQ(scancode_of(key), number);
}

struct Table {
  Actions actions;
  int nudged = 0, undone = 0;
  bool held = false, allowed = true;
  Table() {
    actions.add(
        {.name = "nudge", .label = "Nudge", .group = "G", .keys = "N", .kind = ActionKind::repeat, .run = [this] {
           ++nudged;
         }});
    actions.add({.name = "undo",
                 .label = "Undo",
                 .group = "G",
                 .keys = "Ctrl+Z Alt+Backspace",
                 .run = [this] { ++undone; },
                 .enabled = [this] { return allowed; }});
    actions.add({.name = "flicker",
                 .label = "Flicker",
                 .group = "G",
                 .keys = "F",
                 .kind = ActionKind::hold,
                 .run_hold = [this](bool on) { held = on; }});
  }
  bool press(const char* chord, bool repeat = false, bool typing = false) {
    return actions.key_down(parse_chord(chord), repeat, typing);
  }
};

TEST(Actions, RunByTheirKeys) {
  Table t;
  EXPECT_TRUE(t.press("N"));
  EXPECT_TRUE(t.press("N", true));
  EXPECT_EQ(t.nudged, 2);
  EXPECT_FALSE(t.press("Shift+N"));
  EXPECT_TRUE(t.press("Ctrl+Z"));
  EXPECT_TRUE(t.press("Ctrl+Z", true));  // taken, but a press does not repeat
  EXPECT_EQ(t.undone, 1);
  t.allowed = false;
  EXPECT_FALSE(t.press("Ctrl+Z"));
  EXPECT_FALSE(t.actions.run("undo"));
  EXPECT_EQ(t.undone, 1);
  EXPECT_EQ(t.actions.key_text("undo"), "Ctrl+Z");
}

TEST(Actions, LettersBelongToTextFieldsWhileTyping) {
  Table t;
  EXPECT_FALSE(t.press("N", false, true));
  EXPECT_FALSE(t.press("Ctrl+Z", false, true));
  EXPECT_EQ(t.nudged + t.undone, 0);
}

TEST(Actions, HoldEndsWithItsKeyWhateverTheModifiers) {
  Table t;
  EXPECT_TRUE(t.press("F"));
  EXPECT_TRUE(t.held);
  t.actions.key_up(parse_chord("Shift+F").key);
  EXPECT_FALSE(t.held);
  t.press("F");
  t.actions.release_all();
  EXPECT_FALSE(t.held);
}

TEST(Actions, RebindingReplacesKeysAndReportsMistakes) {
  Table t;
  t.actions.rebind("# mine\nnudge = F PageUp\nundo =\n", "keys");
  EXPECT_TRUE(t.press("F"));
  EXPECT_TRUE(t.press("PageUp"));
  EXPECT_EQ(t.nudged, 2);
  EXPECT_FALSE(t.held);  // F was taken from it
  EXPECT_FALSE(t.press("N"));
  EXPECT_FALSE(t.press("Ctrl+Z"));
  for (const char* text : {"nudge = N\njump = J\n", "nudge\n", "= N\n", "nudge = Hyper+N\n", "nudge it = N\n"}) {
    EXPECT_THROW(t.actions.rebind(text, "keys"), ps::InputError) << text;
    EXPECT_TRUE(t.press("PageUp"));  // as before the mistake
    EXPECT_FALSE(t.press("N"));
  }
}

}  // namespace
}  // namespace actions_test
