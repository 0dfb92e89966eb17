#include "gui/platform/keyboard.h"

#include <SDL_keyboard.h>

#include <optional>

#include "gui/input/keyboard_layout.h"
#include "gui/platform/events.h"
#include "gui/platform/x_server.h"

namespace ps::gui {
namespace {

int layout_read = 0;

/// The number that X servers give a key: 8 more than the Linux kernel's; Key::none for other keys.
struct XKeys {
  int first;
  const char* us;  ///< what a US keyboard has in the places that follow
};
constexpr XKeys x_keys[] = {{10, "1234567890-="}, {24, "qwertyuiop[]"}, {38, "asdfghjkl;'`"}, {51, "\\zxcvbnm,./"}};
constexpr int x_key_beside_shift = 94;

/// The character of a keysym; 0 if it is none or beyond Latin-1 and Unicode's own. A dead key is the sign on it.
char32_t character_of(unsigned long symbol) {
  constexpr unsigned long unicode = 0x01000000, dead_keys = 0xFE50;
  constexpr char32_t dead[] = {U'`', 0xB4, U'^', U'~', 0xAF, 0x2D8, 0x2D9, 0xA8};
  if ((symbol > 0x20 && symbol < 0x7F) || (symbol > 0xA0 && symbol <= 0xFF)) return static_cast<char32_t>(symbol);
  if (symbol > unicode && symbol < unicode + 0x110000) return static_cast<char32_t>(symbol - unicode);
  if (symbol >= dead_keys && symbol < dead_keys + std::size(dead)) return dead[symbol - dead_keys];
  return 0;
}

/// The character that a key types without Shift according to SDL, 0 for a dead or other key.
char32_t sdl_character(Key place) {
  const SDL_Keycode code = SDL_GetKeyFromScancode(static_cast<SDL_Scancode>(scancode_of(place)));
  return code > 0x20 && (code & SDLK_SCANCODE_MASK) == 0 ? static_cast<char32_t>(code) : 0;
}

void read_place(SDL_Window* window, Key place, int number, KeyboardLayout& layout) {
  constexpr char32_t unknown = 0xFFFD;  // types something of which no shortcut is made
  const char32_t plain = sdl_character(place);
  if (!symbol_on_key(window, number, layout_read, KeyboardLayout::alone)) {
    static const KeyboardLayout us = KeyboardLayout::us();
    layout.set(place, KeyboardLayout::alone, plain);
    if (plain == us.character(place, KeyboardLayout::alone))
      layout.set(place, KeyboardLayout::with_shift, us.character(place, KeyboardLayout::with_shift));
    return;
  }
  for (const auto level :
       {KeyboardLayout::alone, KeyboardLayout::with_shift, KeyboardLayout::with_alt_gr, KeyboardLayout::with_both}) {
    const unsigned long symbol = *symbol_on_key(window, number, layout_read, level);
    const char32_t character = character_of(symbol);
    layout.set(place, level, character != 0 || symbol == 0 ? character : unknown);
  }
  if (layout.character(place, KeyboardLayout::alone) == unknown && plain != 0)
    layout.set(place, KeyboardLayout::alone, plain);
}

}  // namespace

void read_keyboard(SDL_Window* window) {
  layout_read = layout_in_use(window);
  KeyboardLayout layout;
  for (const XKeys& row : x_keys) {
    int number = row.first;
    for (const char* us = row.us; *us != 0; ++us, ++number)
      read_place(window, parse_chord({us, 1}).key, number, layout);
  }
  read_place(window, Key::beside_shift, x_key_beside_shift, layout);
  keyboard_layout() = layout;
}

void follow_keyboard(SDL_Window* window) {
  if (layout_in_use(window) != layout_read) read_keyboard(window);
}

}  // namespace ps::gui
