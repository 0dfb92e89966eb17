#include <SDL_scancode.h>
#include <fmt/format.h>

#include <array>

#include "base/check.h"
#include "gui/input/actions.h"

namespace ps::gui {
namespace {

struct KeyName {
  std::string_view name;
  int scancode;
};

constexpr std::array key_names{
    KeyName{"Enter", SDL_SCANCODE_RETURN},
    KeyName{"Esc", SDL_SCANCODE_ESCAPE},
    KeyName{"Backspace", SDL_SCANCODE_BACKSPACE},
    KeyName{"Delete", SDL_SCANCODE_DELETE},
    KeyName{"Insert", SDL_SCANCODE_INSERT},
    KeyName{"Tab", SDL_SCANCODE_TAB},
    KeyName{"Space", SDL_SCANCODE_SPACE},
    KeyName{"Left", SDL_SCANCODE_LEFT},
    KeyName{"Right", SDL_SCANCODE_RIGHT},
    KeyName{"Up", SDL_SCANCODE_UP},
    KeyName{"Down", SDL_SCANCODE_DOWN},
    KeyName{"PageUp", SDL_SCANCODE_PAGEUP},
    KeyName{"PageDown", SDL_SCANCODE_PAGEDOWN},
    KeyName{"Home", SDL_SCANCODE_HOME},
    KeyName{"End", SDL_SCANCODE_END},
    KeyName{"-", SDL_SCANCODE_MINUS},
    KeyName{"=", SDL_SCANCODE_EQUALS},
    KeyName{"[", SDL_SCANCODE_LEFTBRACKET},
    KeyName{"]", SDL_SCANCODE_RIGHTBRACKET},
    KeyName{";", SDL_SCANCODE_SEMICOLON},
    KeyName{"'", SDL_SCANCODE_APOSTROPHE},
    KeyName{"`", SDL_SCANCODE_GRAVE},
    KeyName{",", SDL_SCANCODE_COMMA},
    KeyName{".", SDL_SCANCODE_PERIOD},
    KeyName{"/", SDL_SCANCODE_SLASH},
    KeyName{"\\", SDL_SCANCODE_BACKSLASH},
    KeyName{"KeypadPlus", SDL_SCANCODE_KP_PLUS},
    KeyName{"KeypadMinus", SDL_SCANCODE_KP_MINUS},
    KeyName{"KeypadEnter", SDL_SCANCODE_KP_ENTER},
};

/// 0 if there is no such key.
int find_scancode(std::string_view name) {
  if (name.size() == 1) {
    const char c = name[0];
    if (c >= 'A' && c <= 'Z') return SDL_SCANCODE_A + (c - 'A');
    if (c >= 'a' && c <= 'z') return SDL_SCANCODE_A + (c - 'a');
    if (c >= '1' && c <= '9') return SDL_SCANCODE_1 + (c - '1');
    if (c == '0') return SDL_SCANCODE_0;
  }
  for (int i = 1; i <= 12; ++i)
    if (name == fmt::format("F{}", i)) return SDL_SCANCODE_F1 + i - 1;
  for (const KeyName& key : key_names)
    if (key.name == name) return key.scancode;
  return 0;
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
  if (rest == "?" || rest == "+") {  // shifted on the US layout
    chord.shift = true;
    rest = rest == "?" ? "/" : "=";
  }
  chord.scancode = find_scancode(rest);
  if (chord.scancode == 0)
    throw InputError(fmt::format("found '{}', expected a key such as Ctrl+Shift+Z, F11, PageDown or [", text));
  return chord;
}

std::string chord_text(const Chord& chord) {
  std::string key;
  bool shift = chord.shift;
  if (chord.scancode == 0) return {};
  if (chord.scancode >= SDL_SCANCODE_A && chord.scancode <= SDL_SCANCODE_Z)
    key = static_cast<char>('A' + chord.scancode - SDL_SCANCODE_A);
  else if (chord.scancode >= SDL_SCANCODE_1 && chord.scancode <= SDL_SCANCODE_9)
    key = static_cast<char>('1' + chord.scancode - SDL_SCANCODE_1);
  else if (chord.scancode == SDL_SCANCODE_0)
    key = "0";
  else if (chord.scancode >= SDL_SCANCODE_F1 && chord.scancode <= SDL_SCANCODE_F12)
    key = fmt::format("F{}", chord.scancode - SDL_SCANCODE_F1 + 1);
  else if (shift && (chord.scancode == SDL_SCANCODE_SLASH || chord.scancode == SDL_SCANCODE_EQUALS)) {
    key = chord.scancode == SDL_SCANCODE_SLASH ? "?" : "+";
    shift = false;
  } else {
    for (const KeyName& name : key_names)
      if (name.scancode == chord.scancode) key = name.name;
  }
  return fmt::format("{}{}{}{}", chord.ctrl ? "Ctrl+" : "", shift ? "Shift+" : "", chord.alt ? "Alt+" : "", key);
}

}  // namespace ps::gui
