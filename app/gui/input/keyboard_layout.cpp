#include "gui/input/keyboard_layout.h"

#include <algorithm>
#include <string_view>

#include "base/check.h"

namespace ps::gui {
namespace {

using Level = KeyboardLayout::Level;

bool is_letter(Key key) { return key >= Key::a && key <= Key::z; }
bool is_digit(Key key) { return key >= Key::digit_1 && key <= Key::digit_0; }

constexpr std::u32string_view us_digits = U"1234567890", us_signs = U"-=[];'`,./\\";
constexpr std::u32string_view us_shifted_digits = U"!@#$%^&*()", us_shifted_signs = U"_+{}:\"~<>?|";

/// The key whose name is the letter, digit or sign; Key::none for any other.
Key key_named(char32_t character) {
  if (character >= U'a' && character <= U'z') return key_after(Key::a, static_cast<int>(character - U'a'));
  if (character >= U'A' && character <= U'Z') return key_after(Key::a, static_cast<int>(character - U'A'));
  if (character == U'?') return Key::question;
  if (character == U'+') return Key::plus;
  if (const auto at = us_digits.find(character); at != us_digits.npos)
    return key_after(Key::digit_1, static_cast<int>(at));
  if (const auto at = us_signs.find(character); at != us_signs.npos) return key_after(Key::minus, static_cast<int>(at));
  return Key::none;
}

/// Latin with accents, Greek and Cyrillic, whose capitals lie at a fixed distance in Unicode.
char32_t capital(char32_t c) {
  const auto among = [c](char32_t first, char32_t last) { return c >= first && c <= last; };
  if (among(U'a', U'z') || (among(0xE0, 0xFE) && c != 0xF7) || (among(0x3B1, 0x3C9) && c != 0x3C2) ||
      among(0x430, 0x44F))
    return c - 0x20;
  return among(0x450, 0x45F) ? c - 0x50 : c;
}

/// Latin, Greek and Cyrillic; spaces are not seen.
bool fonts_show(char32_t c) { return (c > 0x20 && c < 0x7F) || (c > 0xA0 && c < 0x180) || (c >= 0x384 && c < 0x430); }

std::string utf8_of(char32_t c) {
  if (c < 0x80) return {static_cast<char>(c)};
  if (c < 0x800) return {static_cast<char>(0xC0 | (c >> 6)), static_cast<char>(0x80 | (c & 0x3F))};
  return {static_cast<char>(0xE0 | (c >> 12)), static_cast<char>(0x80 | ((c >> 6) & 0x3F)),
          static_cast<char>(0x80 | (c & 0x3F))};
}

const KeyboardLayout& us_layout() {
  static const KeyboardLayout layout = KeyboardLayout::us();
  return layout;
}

}  // namespace

bool KeyboardLayout::types(Key place) {
  return is_letter(place) || is_digit(place) || (place >= Key::minus && place <= Key::backslash) ||
         place == Key::beside_shift;
}

KeyboardLayout KeyboardLayout::us() {
  KeyboardLayout layout;
  for (int i = 0; i < 26; ++i) {
    layout.set(key_after(Key::a, i), alone, U'a' + static_cast<char32_t>(i));
    layout.set(key_after(Key::a, i), with_shift, U'A' + static_cast<char32_t>(i));
  }
  const auto row = [&](Key first, std::u32string_view plain, std::u32string_view shifted) {
    for (std::size_t i = 0; i < plain.size(); ++i) {
      layout.set(key_after(first, static_cast<int>(i)), alone, plain[i]);
      layout.set(key_after(first, static_cast<int>(i)), with_shift, shifted[i]);
    }
  };
  row(Key::digit_1, us_digits, us_shifted_digits);
  row(Key::minus, us_signs, us_shifted_signs);
  return layout;
}

void KeyboardLayout::set(Key place, Level level, char32_t character) {
  PS_ASSERT(types(place), "a key that types");
  characters_[index(place)][level] = character;
  typed_.reset();
  for (const auto& levels : characters_)
    for (const char32_t each : levels) typed_.set(index(key_named(each)));
}

KeyMeanings KeyboardLayout::meanings(const KeyPress& press) const {
  const Chord at_place{press.place, press.ctrl, press.shift, press.alt || press.right_alt};
  if (!types(press.place)) return at_place;
  KeyMeanings result(at_place, {});
  const auto add = [&](Chord chord) {
    if (chord.key == Key::none) return;
    if (std::find(result.chords.begin(), result.chords.end(), chord) == result.chords.end())
      result.chords.push_back(chord);
  };
  // A letter is another one with Shift; a sign that Shift types is a sign of its own.
  const auto typed = [&](Key key, bool alt) { return Chord{key, press.ctrl, is_letter(key) && press.shift, alt}; };
  if (const char32_t c = character(press.place, press.shift ? with_both : with_alt_gr); press.right_alt && c != 0) {
    add(typed(key_named(c), press.alt));
    return result;  // AltGr is no modifier there
  }
  const Key key = key_named(character(press.place, alone));
  add(typed(key_named(character(press.place, press.shift ? with_shift : alone)), at_place.alt));
  add({key, press.ctrl, press.shift, at_place.alt});
  if (is_digit(press.place)) add(at_place);
  if (press.place == Key::beside_shift) return result;
  const Key us_key = key_named(us_layout().character(press.place, press.shift ? with_shift : alone));
  if (!has(us_key) || !latin()) add(typed(us_key, at_place.alt));
  if (!has(press.place) || !latin()) add(at_place);
  return result;
}

KeyPress KeyboardLayout::press_for(const Chord& chord) const {
  const KeyPress same{chord.key, chord.ctrl, chord.shift, chord.alt, false};
  if (!types(chord.key) && chord.key != Key::question && chord.key != Key::plus) return same;
  KeyPress best = same;
  std::size_t best_rank = SIZE_MAX;
  for (const bool right_alt : {false, true})
    for (const bool shift : {false, true})
      for (Key place = Key::a; place < Key::other; place = key_after(place, 1)) {
        if (!types(place)) continue;
        const KeyPress press{place, chord.ctrl, shift, chord.alt, right_alt};
        const auto all = meanings(press).chords;
        const auto rank = static_cast<std::size_t>(std::find(all.begin(), all.end(), chord) - all.begin());
        if (rank == all.size() || rank >= best_rank) continue;
        best = press;
        best_rank = rank;
      }
  return best;
}

std::string KeyboardLayout::label_of_place(Key place) const {
  const char32_t sign = types(place) && !is_digit(place) ? capital(character(place, alone)) : 0;
  return fonts_show(sign) ? utf8_of(sign) : chord_text({.key = place});
}

std::string KeyboardLayout::labels_of_places(std::string_view letters) const {
  std::string result;
  for (const char letter : letters)
    result += (result.empty() ? "" : " ") + label_of_place(key_named(static_cast<unsigned char>(letter)));
  return result;
}

std::string KeyboardLayout::label(const Chord& chord) const {
  const bool by_place =
      (types(chord.key) && !is_digit(chord.key)) || chord.key == Key::question || chord.key == Key::plus;
  if (!by_place || has(chord.key)) return chord_text(chord);
  const KeyPress press = press_for(chord);
  return chord_modifiers({press.place, press.ctrl, press.shift, press.alt}) + label_of_place(press.place);
}

KeyboardLayout& keyboard_layout() {
  static KeyboardLayout layout = KeyboardLayout::us();
  return layout;
}

}  // namespace ps::gui
