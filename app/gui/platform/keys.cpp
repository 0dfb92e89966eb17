// Our keys and SDL's numbers of them.
#include <SDL_scancode.h>

#include <algorithm>
#include <iterator>

#include "gui/platform/events.h"

namespace ps::gui {
namespace {

struct Row {
  Key key;
  int scancode;
};

/// Letters, digits and function keys follow one another here and there; these are the others.
constexpr Row rows[] = {
    {Key::enter, SDL_SCANCODE_RETURN},
    {Key::escape, SDL_SCANCODE_ESCAPE},
    {Key::backspace, SDL_SCANCODE_BACKSPACE},
    {Key::del, SDL_SCANCODE_DELETE},
    {Key::insert, SDL_SCANCODE_INSERT},
    {Key::tab, SDL_SCANCODE_TAB},
    {Key::space, SDL_SCANCODE_SPACE},
    {Key::left, SDL_SCANCODE_LEFT},
    {Key::right, SDL_SCANCODE_RIGHT},
    {Key::up, SDL_SCANCODE_UP},
    {Key::down, SDL_SCANCODE_DOWN},
    {Key::page_up, SDL_SCANCODE_PAGEUP},
    {Key::page_down, SDL_SCANCODE_PAGEDOWN},
    {Key::home, SDL_SCANCODE_HOME},
    {Key::end, SDL_SCANCODE_END},
    {Key::minus, SDL_SCANCODE_MINUS},
    {Key::equals, SDL_SCANCODE_EQUALS},
    {Key::left_bracket, SDL_SCANCODE_LEFTBRACKET},
    {Key::right_bracket, SDL_SCANCODE_RIGHTBRACKET},
    {Key::semicolon, SDL_SCANCODE_SEMICOLON},
    {Key::apostrophe, SDL_SCANCODE_APOSTROPHE},
    {Key::grave, SDL_SCANCODE_GRAVE},
    {Key::comma, SDL_SCANCODE_COMMA},
    {Key::period, SDL_SCANCODE_PERIOD},
    {Key::slash, SDL_SCANCODE_SLASH},
    {Key::backslash, SDL_SCANCODE_BACKSLASH},
    {Key::beside_shift, SDL_SCANCODE_NONUSBACKSLASH},
    {Key::keypad_plus, SDL_SCANCODE_KP_PLUS},
    {Key::keypad_minus, SDL_SCANCODE_KP_MINUS},
    {Key::keypad_enter, SDL_SCANCODE_KP_ENTER},
    {Key::ctrl, SDL_SCANCODE_LCTRL},
    {Key::ctrl, SDL_SCANCODE_RCTRL},
    {Key::shift, SDL_SCANCODE_LSHIFT},
    {Key::shift, SDL_SCANCODE_RSHIFT},
    {Key::alt, SDL_SCANCODE_LALT},
    {Key::alt, SDL_SCANCODE_RALT},
};

/// Keys that follow one another, in both.
struct Run {
  Key first, last;
  int scancode;  ///< of the first
};
constexpr Run runs[] = {{Key::a, Key::z, SDL_SCANCODE_A},
                        {Key::digit_1, Key::digit_0, SDL_SCANCODE_1},
                        {Key::f1, Key::f12, SDL_SCANCODE_F1}};

int length(const Run& run) { return static_cast<int>(run.last) - static_cast<int>(run.first) + 1; }

}  // namespace

int scancode_of(Key key) {
  for (const Run& run : runs)
    if (key >= run.first && key <= run.last) return run.scancode + static_cast<int>(key) - static_cast<int>(run.first);
  const auto row = std::find_if(std::begin(rows), std::end(rows), [&](const Row& r) { return r.key == key; });
  return row == std::end(rows) ? SDL_SCANCODE_UNKNOWN : row->scancode;
}

Key key_of(int scancode) {
  for (const Run& run : runs)
    if (scancode >= run.scancode && scancode < run.scancode + length(run))
      return key_after(run.first, scancode - run.scancode);
  const auto row = std::find_if(std::begin(rows), std::end(rows), [&](const Row& r) { return r.scancode == scancode; });
  return row == std::end(rows) ? Key::other : row->key;
}

}  // namespace ps::gui
