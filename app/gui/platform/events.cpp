#include "gui/platform/events.h"

#include <SDL.h>

#include <algorithm>
#include <cstring>
#include <iterator>

namespace ps::gui {
namespace {

/// In the order of MouseButton.
constexpr Uint8 button_codes[] = {SDL_BUTTON_LEFT, SDL_BUTTON_RIGHT, SDL_BUTTON_MIDDLE, SDL_BUTTON_X1, SDL_BUTTON_X2};

SDL_Event make(Uint32 type) {
  SDL_Event event{};
  event.type = type;
  event.common.timestamp = SDL_GetTicks();
  return event;
}

void push_scancode(unsigned window, int scancode, bool down, Uint16 modifiers) {
  SDL_Event event = make(down ? SDL_KEYDOWN : SDL_KEYUP);
  event.key.windowID = window;
  event.key.state = down ? SDL_PRESSED : SDL_RELEASED;
  event.key.keysym.scancode = static_cast<SDL_Scancode>(scancode);
  event.key.keysym.sym = SDL_GetKeyFromScancode(event.key.keysym.scancode);
  event.key.keysym.mod = modifiers;
  SDL_PushEvent(&event);
}

}  // namespace

InputEvent translated(const SDL_Event& event) {
  using Kind = InputEvent::Kind;
  const auto point = [](auto x, auto y) { return WindowPoint{static_cast<float>(x), static_cast<float>(y)}; };
  InputEvent out;
  switch (event.type) {
  case SDL_MOUSEMOTION:
    if (event.motion.which == SDL_TOUCH_MOUSEID) break;
    out.kind = Kind::move;
    out.at = point(event.motion.x, event.motion.y);
    break;
  case SDL_MOUSEBUTTONDOWN:
  case SDL_MOUSEBUTTONUP: {
    const auto button = std::find(std::begin(button_codes), std::end(button_codes), event.button.button);
    if (button == std::end(button_codes)) break;
    out.kind = Kind::button;
    out.at = point(event.button.x, event.button.y);
    out.button = static_cast<MouseButton>(button - std::begin(button_codes));
    out.down = event.type == SDL_MOUSEBUTTONDOWN;
    break;
  }
  case SDL_MOUSEWHEEL:
    out.kind = Kind::wheel;
    out.at = {event.wheel.preciseX, event.wheel.preciseY};
    break;
  case SDL_KEYDOWN:
  case SDL_KEYUP:
    out.kind = Kind::key;
    out.key = key_of(event.key.keysym.scancode);
    out.down = event.type == SDL_KEYDOWN;
    out.repeat = event.key.repeat != 0;
    out.ctrl = (event.key.keysym.mod & KMOD_CTRL) != 0;
    out.shift = (event.key.keysym.mod & KMOD_SHIFT) != 0;
    out.alt = (event.key.keysym.mod & KMOD_LALT) != 0;
    out.right_alt = (event.key.keysym.mod & (KMOD_RALT | KMOD_MODE)) != 0;
    break;
  case SDL_TEXTINPUT:
    out.kind = Kind::text;
    out.text = event.text.text;
    break;
  case SDL_WINDOWEVENT:
    if (event.window.event == SDL_WINDOWEVENT_LEAVE) out.kind = Kind::leave;
    if (event.window.event == SDL_WINDOWEVENT_FOCUS_LOST) out.kind = Kind::focus_lost;
    if (event.window.event == SDL_WINDOWEVENT_CLOSE) out.kind = Kind::close;
    break;
  case SDL_QUIT:
    out.kind = Kind::close;
    break;
  case SDL_DROPFILE:
    if (!event.drop.file) break;
    out.kind = Kind::drop;
    out.text = event.drop.file;
    SDL_free(event.drop.file);
    break;
  default:  // SDL's other kinds of events, whose number grows
    break;
  }
  return out;
}

void push_move(unsigned window, float x, float y) {
  SDL_Event event = make(SDL_MOUSEMOTION);
  event.motion.windowID = window;
  event.motion.x = static_cast<Sint32>(x);
  event.motion.y = static_cast<Sint32>(y);
  SDL_PushEvent(&event);
}

void push_button(unsigned window, MouseButton button, bool down, float x, float y, int clicks) {
  SDL_Event event = make(down ? SDL_MOUSEBUTTONDOWN : SDL_MOUSEBUTTONUP);
  event.button.windowID = window;
  event.button.button = button_codes[static_cast<std::size_t>(button)];
  event.button.state = down ? SDL_PRESSED : SDL_RELEASED;
  event.button.clicks = static_cast<Uint8>(clicks);
  event.button.x = static_cast<Sint32>(x);
  event.button.y = static_cast<Sint32>(y);
  SDL_PushEvent(&event);
}

void push_wheel(unsigned window, float steps) {
  SDL_Event event = make(SDL_MOUSEWHEEL);
  event.wheel.windowID = window;
  event.wheel.y = static_cast<Sint32>(steps);
  event.wheel.preciseY = steps;
  SDL_PushEvent(&event);
}

void push_key(unsigned window, const Chord& chord, bool down) {
  const KeyPress press = keyboard_layout().press_for(chord);
  Uint16 held = 0;
  const auto modifier = [&](bool wanted, SDL_Scancode scancode, Uint16 bit) {
    if (!wanted) return;
    held = static_cast<Uint16>(down ? held | bit : held & ~bit);
    push_scancode(window, scancode, down, held);
  };
  if (!down) {
    held = static_cast<Uint16>((press.ctrl ? KMOD_LCTRL : 0) | (press.shift ? KMOD_LSHIFT : 0) |
                               (press.alt ? KMOD_LALT : 0) | (press.right_alt ? KMOD_RALT : 0));
    push_scancode(window, scancode_of(press.place), false, held);
  }
  modifier(press.ctrl, SDL_SCANCODE_LCTRL, KMOD_LCTRL);
  modifier(press.shift, SDL_SCANCODE_LSHIFT, KMOD_LSHIFT);
  modifier(press.alt, SDL_SCANCODE_LALT, KMOD_LALT);
  modifier(press.right_alt, SDL_SCANCODE_RALT, KMOD_RALT);
  if (down && press.place != Key::none) push_scancode(window, scancode_of(press.place), true, held);
}

void push_text(unsigned window, const std::string& utf8) {
  for (std::size_t at = 0; at < utf8.size();) {
    std::size_t length = std::min<std::size_t>(SDL_TEXTINPUTEVENT_TEXT_SIZE - 1, utf8.size() - at);
    while (length > 1 && at + length < utf8.size() && (static_cast<unsigned char>(utf8[at + length]) & 0xC0u) == 0x80u)
      --length;
    SDL_Event event = make(SDL_TEXTINPUT);
    event.text.windowID = window;
    std::memcpy(event.text.text, utf8.data() + at, length);
    SDL_PushEvent(&event);
    at += length;
  }
}

void push_drop(unsigned window, const std::string& path) {
  SDL_Event event = make(SDL_DROPFILE);
  event.drop.windowID = window;
  event.drop.file = SDL_strdup(path.c_str());
  SDL_PushEvent(&event);
}

}  // namespace ps::gui
