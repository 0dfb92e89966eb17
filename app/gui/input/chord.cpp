#include <fmt/format.h>

#include <array>
#include <optional>

#include "base/check.h"
#include "gui/input/chord.h"

namespace ps::gui {
namespace {

struct KeyName {
  std::string_view name;
  Key key;
};

constexpr std::array key_names{
    KeyName{"Enter", Key::enter},
    KeyName{"Esc", Key::escape},
    KeyName{"Backspace", Key::backspace},
    KeyName{"Delete", Key::del},
    KeyName{"Insert", Key::insert},
    KeyName{"Tab", Key::tab},
    KeyName{"Space", Key::space},
    KeyName{"Left", Key::left},
    KeyName{"Right", Key::right},
    KeyName{"Up", Key::up},
    KeyName{"Down", Key::down},
    KeyName{"PageUp", Key::page_up},
    KeyName{"PageDown", Key::page_down},
    KeyName{"Home", Key::home},
    KeyName{"End", Key::end},
    KeyName{"-", Key::minus},
    KeyName{"=", Key::equals},
    KeyName{"[", Key::left_bracket},
    KeyName{"]", Key::right_bracket},
    KeyName{";", Key::semicolon},
    KeyName{"'", Key::apostrophe},
    KeyName{"`", Key::grave},
    KeyName{",", Key::comma},
    KeyName{".", Key::period},
    KeyName{"/", Key::slash},
    KeyName{"\\", Key::backslash},
    KeyName{"?", Key::question},
    KeyName{"+", Key::plus},
    KeyName{"KeypadPlus", Key::keypad_plus},
    KeyName{"KeypadMinus", Key::keypad_minus},
    KeyName{"KeypadEnter", Key::keypad_enter},
};

/// Key::none if there is no such key.
Key find_key(std::string_view name) {
  if (name.size() == 1) {
    const char c = name[0];
    if (c >= 'A' && c <= 'Z') return key_after(Key::a, c - 'A');
    if (c >= 'a' && c <= 'z') return key_after(Key::a, c - 'a');
    if (c >= '1' && c <= '9') return key_after(Key::digit_1, c - '1');
    if (c == '0') return Key::digit_0;
  }
  for (int i = 1; i <= 12; ++i)
    if (name == fmt::format("F{}", i)) return key_after(Key::f1, i - 1);
  for (const KeyName& key : key_names)
    if (key.name == name) return key.key;
  return Key::none;
}

/// How far a key of a row is from the row's first one; nullopt for another key.
std::optional<int> place_in_row(Key key, Key first, Key last) {
  if (key < first || key > last) return {};
  return static_cast<int>(key) - static_cast<int>(first);
}

}  // namespace

Chord parse_chord(std::string_view text) {
  Chord chord;
  std::string_view rest = text;
  const auto take = [&](std::string_view modifier) {
    if (!rest.starts_with(modifier) || rest.size() == modifier.size()) return false;
    rest.remove_prefix(modifier.size());
    return true;
  };
  for (bool more = true; more;) {
    more = false;
    if (take("Ctrl+")) more = chord.ctrl = true;
    if (take("Shift+")) more = chord.shift = true;
    if (take("Alt+")) more = chord.alt = true;
  }
  chord.key = find_key(rest);
  if (chord.key == Key::none)
    throw InputError(fmt::format("found '{}', expected a key such as Ctrl+Shift+Z, F11, PageDown or [", text));
  if (chord.shift && (chord.key == Key::slash || chord.key == Key::equals)) {  // what they type on the US layout
    chord.key = chord.key == Key::slash ? Key::question : Key::plus;
    chord.shift = false;
  }
  return chord;
}

std::string chord_modifiers(const Chord& chord) {
  return fmt::format("{}{}{}", chord.ctrl ? "Ctrl+" : "", chord.shift ? "Shift+" : "", chord.alt ? "Alt+" : "");
}

std::string chord_text(const Chord& chord) {
  std::string key;
  if (chord.key == Key::none) return {};
  if (const auto letter = place_in_row(chord.key, Key::a, Key::z))
    key = static_cast<char>('A' + *letter);
  else if (const auto digit = place_in_row(chord.key, Key::digit_1, Key::digit_0))
    key = static_cast<char>('0' + (*digit + 1) % 10);
  else if (const auto number = place_in_row(chord.key, Key::f1, Key::f12))
    key = fmt::format("F{}", *number + 1);
  else
    for (const KeyName& name : key_names)
      if (name.key == chord.key) key = name.name;
  return chord_modifiers(chord) + key;
}

}  // namespace ps::gui
