#pragma once
#include <cstdint>

namespace ps::gui {

/// A key. In a Chord letters and signs are what is typed, in an InputEvent the place where a US keyboard has them;
/// keyboard_layout.h leads from one to the other. Letters, digits from 1, function keys and signs that have a place
/// follow one another; chord.cpp has the names. Left and right modifiers are one key.
enum class Key : std::uint8_t {
  none,
  // clang-format off
  a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v, w, x, y, z,
  digit_1, digit_2, digit_3, digit_4, digit_5, digit_6, digit_7, digit_8, digit_9, digit_0,
  f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12,
  enter, escape, backspace, del, insert, tab, space,
  left, right, up, down, page_up, page_down, home, end,
  minus, equals, left_bracket, right_bracket, semicolon, apostrophe, grave, comma, period, slash, backslash,
  keypad_plus, keypad_minus, keypad_enter,
  ctrl, shift, alt,
  beside_shift,    ///< a place that US keyboards lack: between Shift and Z
  question, plus,  ///< signs without a place of their own
  // clang-format on
  other  ///< one without a name here; nothing can be bound to it
};

/// The key that many `places` after another one in the list.
constexpr Key key_after(Key first, int places) { return static_cast<Key>(static_cast<int>(first) + places); }

}  // namespace ps::gui
