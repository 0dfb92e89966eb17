#pragma once
#include <string_view>

#include "gui/input/keyboard_layout.h"

namespace ps::test {

/// Sets what the rows of a keyboard type, from the digits down and from the left, on one level. A space types nothing.
inline void set_rows(gui::KeyboardLayout& layout, gui::KeyboardLayout::Level level, std::u32string_view digits,
                     std::u32string_view upper, std::u32string_view middle, std::u32string_view lower) {
  const auto row = [&](std::string_view places, std::u32string_view characters) {
    for (std::size_t i = 0; i < places.size() && i < characters.size(); ++i)
      layout.set(gui::parse_chord(places.substr(i, 1)).key, level, characters[i] == U' ' ? 0 : characters[i]);
  };
  row("`1234567890-=", digits);
  row("qwertyuiop[]", upper);
  row("asdfghjkl;'\\", middle);
  row("zxcvbnm,./", lower);
}

inline gui::KeyboardLayout german() {  // DIN 2137
  gui::KeyboardLayout layout;
  set_rows(layout, layout.alone, U"^1234567890ß\u00B4", U"qwertzuiopü+", U"asdfghjklöä#", U"yxcvbnm,.-");
  set_rows(layout, layout.with_shift, U"°!\"§$%&/()=?`", U"QWERTZUIOPÜ*", U"ASDFGHJKLÖÄ'", U"YXCVBNM;:_");
  set_rows(layout, layout.with_alt_gr, U"  ²³   {[]}\\ ", U"@ €        ~", U"", U"      µ   ");
  return layout;
}

inline gui::KeyboardLayout french() {  // AZERTY
  gui::KeyboardLayout layout;
  set_rows(layout, layout.alone, U"²&é\"'(-è_çà)=", U"azertyuiop^$", U"qsdfghjklmù*", U"wxcvbn,;:!");
  set_rows(layout, layout.with_shift, U" 1234567890°+", U"AZERTYUIOP¨£", U"QSDFGHJKLM%µ", U"WXCVBN?./§");
  set_rows(layout, layout.with_alt_gr, U"  ~#{[|`\\^@]}", U"  €        ¤", U"", U"");
  return layout;
}

inline gui::KeyboardLayout russian() {  // ЙЦУКЕН
  gui::KeyboardLayout layout;
  set_rows(layout, layout.alone, U"ё1234567890-=", U"йцукенгшщзхъ", U"фывапролджэ\\", U"ячсмитьбю.");
  set_rows(layout, layout.with_shift, U"Ё!\"№;%:?*()_+", U"ЙЦУКЕНГШЩЗХЪ", U"ФЫВАПРОЛДЖЭ/", U"ЯЧСМИТЬБЮ,");
  return layout;
}

inline gui::KeyboardLayout dvorak() {
  gui::KeyboardLayout layout;
  set_rows(layout, layout.alone, U"`1234567890[]", U"',.pyfgcrl/=", U"aoeuidhtns-\\", U";qjkxbmwvz");
  set_rows(layout, layout.with_shift, U"~!@#$%^&*(){}", U"\"<>PYFGCRL?+", U"AOEUIDHTNS_|", U":QJKXBMWVZ");
  return layout;
}

}  // namespace ps::test
