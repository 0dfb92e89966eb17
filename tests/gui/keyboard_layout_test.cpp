// What keys mean on keyboards that are not American, against the layouts as they are printed.
#include "gui/input/keyboard_layout.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "gui/input/actions.h"
#include "gui/keyboard_layouts.h"

namespace ps::gui::keyboard_layout_test {
namespace {

Key place(const char* us) { return parse_chord(us).key; }

/// The meanings of a key at a place of a US keyboard: "y", "Shift+-"; AltGr where asked for.
std::string meanings(const KeyboardLayout& layout, const char* us, bool alt_gr = false) {
  Chord chord = parse_chord(us);
  if (chord.key == Key::question) chord = {Key::slash, chord.ctrl, true, chord.alt};
  if (chord.key == Key::plus) chord = {Key::equals, chord.ctrl, true, chord.alt};
  std::string all;
  for (const Chord& each : layout.meanings({chord.key, chord.ctrl, chord.shift, chord.alt, alt_gr}).chords)
    all += (all.empty() ? "" : " ") + chord_text(each);
  return all;
}

TEST(KeyboardLayout, AmericanKeysAreWhatTheyWere) {
  const KeyboardLayout us = KeyboardLayout::us();
  for (const char* chord : {"A", "Ctrl+Z", "Shift+N", "Ctrl+Shift+Z", "1", "Ctrl+0", "`", ",", ".", "[", "-", "=",
                            "Ctrl+=", "Enter", "Ctrl+Left", "F5", "KeypadPlus", "Alt+Up"})
    EXPECT_EQ(meanings(us, chord), chord);
  EXPECT_EQ(meanings(us, "?").substr(0, 1), "?");
  EXPECT_EQ(meanings(us, "Ctrl++").substr(0, 6), "Ctrl++");
  EXPECT_EQ(meanings(us, "A", true), "Alt+A") << "the right Alt key is no AltGr where it types nothing";
}

TEST(KeyboardLayout, GermanLettersAndSignsAreThoseOnTheKeys) {
  const KeyboardLayout de = test::german();
  EXPECT_EQ(meanings(de, "Y"), "Z");
  EXPECT_EQ(meanings(de, "Ctrl+Y"), "Ctrl+Z");
  EXPECT_EQ(meanings(de, "Ctrl+Shift+Y"), "Ctrl+Shift+Z");
  EXPECT_EQ(meanings(de, "Z"), "Y");
  EXPECT_EQ(meanings(de, "Shift+-").substr(0, 1), "?");
  EXPECT_EQ(meanings(de, "-"), "") << "ß is no sign of ours, and - is elsewhere";
  EXPECT_EQ(meanings(de, "/"), "-");
  EXPECT_EQ(meanings(de, "]"), "+");
  EXPECT_EQ(meanings(de, "Ctrl+]"), "Ctrl++");
  EXPECT_EQ(meanings(de, "["), "") << "ü";
  EXPECT_EQ(meanings(de, "8", true), "[");
  EXPECT_EQ(meanings(de, "7", true), "") << "{";
  EXPECT_EQ(meanings(de, "Shift+7"), "/ Shift+7");
  EXPECT_EQ(meanings(de, "?"), "Shift+-") << "_, of which no shortcut is made: the key with Shift";
  EXPECT_EQ(meanings(de, "+"), "`") << "a dead key is its sign";
}

TEST(KeyboardLayout, FrenchDigitsAreKeysByPlace) {
  const KeyboardLayout fr = test::french();
  EXPECT_EQ(meanings(fr, "Q"), "A");
  EXPECT_EQ(meanings(fr, "Ctrl+Q"), "Ctrl+A");
  EXPECT_EQ(meanings(fr, "Ctrl+A"), "Ctrl+Q");
  EXPECT_EQ(meanings(fr, "1"), "1") << "& types no sign of ours";
  EXPECT_EQ(meanings(fr, "Ctrl+3"), "Ctrl+3");
  EXPECT_EQ(meanings(fr, "Ctrl+4"), "Ctrl+' Ctrl+4");
  EXPECT_EQ(meanings(fr, "6"), "- 6");
  EXPECT_EQ(meanings(fr, "0"), "0");
  EXPECT_EQ(meanings(fr, "Shift+1"), "1 Shift+1");
  EXPECT_EQ(meanings(fr, "M").substr(0, 1), ",");
  EXPECT_EQ(meanings(fr, "Shift+M").substr(0, 1), "?");
  EXPECT_EQ(meanings(fr, "Shift+,").substr(0, 1), ".");
  EXPECT_EQ(meanings(fr, "7", true), "`");
  EXPECT_EQ(meanings(fr, "0", true), "") << "@";
}

TEST(KeyboardLayout, RussianKeysAreByPlaceWhereTheyTypeNoSignOfOurs) {
  const KeyboardLayout ru = test::russian();
  EXPECT_EQ(meanings(ru, "Z"), "Z");
  EXPECT_EQ(meanings(ru, "Ctrl+Shift+Z"), "Ctrl+Shift+Z");
  EXPECT_EQ(meanings(ru, "["), "[");
  EXPECT_EQ(meanings(ru, "`"), "`");
  EXPECT_EQ(meanings(ru, ","), ",");
  EXPECT_EQ(meanings(ru, "/").substr(0, 1), ".");
  EXPECT_EQ(meanings(ru, "Shift+7").substr(0, 1), "?");
  const auto shift_slash = ru.meanings({.place = Key::slash, .shift = true}).chords;
  EXPECT_NE(std::find(shift_slash.begin(), shift_slash.end(), parse_chord("?")), shift_slash.end());
}

TEST(KeyboardLayout, EveryChordIsReachedOnEveryKeyboard) {
  for (const KeyboardLayout& layout :
       {KeyboardLayout::us(), test::german(), test::french(), test::russian(), test::dvorak(), KeyboardLayout()})
    for (const char* text : {"A", "Q", "Ctrl+Z", "Ctrl+Shift+S", "Shift+N", "?", "+",      "=",   "-",        "`", "[",
                             "]", ",", ".",      "Ctrl++",       "Ctrl+-",  "0", "Ctrl+4", "Esc", "Alt+Left", "F1"}) {
      const KeyPress press = layout.press_for(parse_chord(text));
      const auto all = layout.meanings(press).chords;
      EXPECT_NE(std::find(all.begin(), all.end(), parse_chord(text)), all.end()) << text;
    }
  const KeyPress question = test::german().press_for(parse_chord("?"));
  EXPECT_EQ(question.place, Key::minus);
  EXPECT_TRUE(question.shift);
}

TEST(KeyboardLayout, LabelsAreWhatIsOnTheKeys) {
  EXPECT_EQ(test::french().labels_of_places("WASDQE"), "Z Q S D A E");
  EXPECT_EQ(test::german().labels_of_places("WASDQE"), "W A S D Q E");
  EXPECT_EQ(test::russian().labels_of_places("WASDQE"), "Ц Ф Ы В Й У");
  EXPECT_EQ(test::german().label(parse_chord("Ctrl+Z")), "Ctrl+Z");
  EXPECT_EQ(test::german().label(parse_chord("?")), "?");
  EXPECT_EQ(test::russian().label(parse_chord("Ctrl+Shift+Z")), "Ctrl+Shift+Я");
  EXPECT_EQ(test::russian().label(parse_chord("`")), "Ё");
  EXPECT_EQ(test::french().label(parse_chord("Ctrl+1")), "Ctrl+1");
  KeyboardLayout georgian;  // signs that the window's fonts lack
  georgian.set(Key::z, georgian.alone, 0x10D6);
  EXPECT_EQ(georgian.label(parse_chord("Z")), "Z");
}

/// Puts another keyboard in place of the one in use for the length of a test.
struct InUse {
  explicit InUse(const KeyboardLayout& layout) { keyboard_layout() = layout; }
  ~InUse() { keyboard_layout() = KeyboardLayout::us(); }
  InUse(const InUse&) = delete;
  InUse& operator=(const InUse&) = delete;
};

struct Table {
  Actions actions;
  Table() {
    add("light-near", "K", true);
    add("light-left", "J", true);
    add("handles", "H");
    add("gizmo", "T");
    add("undo", "Ctrl+Z");
    add("one-to-one", "1");
    add("smaller", "-");
  }
  void add(const char* name, const char* keys, bool by_place = false) {
    actions.add({.name = name, .label = name, .group = "G", .keys = keys, .by_place = by_place, .run = [] {}});
  }
  std::string by(const KeyboardLayout& layout, const KeyPress& press) {
    return actions.key_down(layout.meanings(press), false, false) ? actions.last_by_key() : "";
  }
};

TEST(KeyboardLayout, KeysByPlaceGiveWayToLetters) {
  const KeyboardLayout layout = test::dvorak();
  const InUse keyboard(layout);
  Table table;
  EXPECT_EQ(table.by(layout, {.place = place("J")}), "handles") << "types h";
  EXPECT_EQ(table.by(layout, {.place = place("C")}), "light-left") << "types j";
  EXPECT_EQ(table.by(layout, {.place = place("V")}), "light-near") << "types k";
  EXPECT_EQ(table.by(layout, {.place = place("K")}), "gizmo") << "types t";
  EXPECT_EQ(table.actions.key_text("light-left"), "J");
  KeyboardLayout colemak = KeyboardLayout::us();  // as far as it matters
  colemak.set(Key::k, colemak.alone, U'e');
  colemak.set(Key::e, colemak.alone, U'f');
  keyboard_layout() = colemak;
  EXPECT_EQ(table.by(colemak, {.place = place("K")}), "light-near") << "types e, which means nothing else";
  EXPECT_EQ(table.actions.key_text("light-near"), "E");
}

TEST(KeyboardLayout, OwnKeysAreThoseThatTypeWhatWasWritten) {
  const KeyboardLayout layout = test::french();
  const InUse keyboard(layout);
  Table table;
  table.actions.rebind("light-left = A\nundo = Shift+;\n", "keys");
  EXPECT_EQ(table.by(layout, {.place = place("Q")}), "light-left");
  EXPECT_EQ(table.by(layout, {.place = place("A")}), "");
  EXPECT_EQ(table.actions.key_text("light-left"), "A");
  EXPECT_EQ(table.by(layout, {.place = place(","), .shift = true}), "undo") << "the key that types ; with Shift";
  EXPECT_EQ(table.by(layout, {.place = place("1")}), "one-to-one");
  EXPECT_EQ(table.by(layout, {.place = place("6")}), "smaller");
  table.actions.rebind("one-to-one = 6\n", "keys");
  EXPECT_EQ(table.by(layout, {.place = place("6")}), "smaller") << "the sign comes first";
  EXPECT_EQ(table.by(layout, {.place = place("6"), .shift = true}), "one-to-one");
}

}  // namespace
}  // namespace ps::gui::keyboard_layout_test
