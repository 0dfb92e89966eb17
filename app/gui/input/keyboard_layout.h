#pragma once
#include <array>
#include <bitset>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "gui/input/chord.h"

namespace ps::gui {

/// A key that goes down while modifiers are held.
struct KeyPress {
  Key place = Key::none;  ///< where a US keyboard has it
  bool ctrl = false, shift = false, alt = false;
  bool right_alt = false;  ///< AltGr, where the layout has signs on it
};

/// What a key press may mean.
struct KeyMeanings {
  Chord at_place;             ///< the key by its place
  std::vector<Chord> chords;  ///< by what it types; the first that does something is meant. May be empty

  KeyMeanings(const Chord& place, std::vector<Chord> all) : at_place(place), chords(std::move(all)) {}
  KeyMeanings(const Chord& only) : at_place(only), chords{only} {}  ///< where place and letter are the same
  /// The first one; Key::other if there is none.
  Chord first() const { return chords.empty() ? Chord{.key = Key::other} : chords.front(); }
};

/// What the keys of a keyboard type. Letters and signs of shortcuts are those that are typed, also with Shift or AltGr,
/// as people read them on their keys; digits are keys by place, since French keyboards type them with Shift alone. What
/// a layout does not have at all, as Russian has no Latin letters, is the key where US keyboards have it.
class KeyboardLayout {
 public:
  /// The levels of a key.
  enum Level { alone, with_shift, with_alt_gr, with_both };

  KeyboardLayout() = default;  ///< of keys that type nothing
  static KeyboardLayout us();
  /// Whether a place types letters, digits or signs.
  static bool types(Key place);
  /// Says what the key there types: a character of Unicode, 0 for nothing. Asserts types(place).
  void set(Key place, Level level, char32_t character);
  char32_t character(Key place, Level level) const { return characters_[index(place)][level]; }

  KeyMeanings meanings(const KeyPress& press) const;
  /// What is pressed to get the chord: the inverse of meanings().
  KeyPress press_for(const Chord& chord) const;
  /// The chord as people see it on their keys: as chord_text(), but a key by place has the letter that is on it.
  std::string label(const Chord& chord) const;
  /// The letter or sign on the key in a place, as capital; the US one if it has none that the window's fonts show.
  std::string label_of_place(Key place) const;
  /// The same for several, given as letters of a US keyboard: "Z Q S D" for "WASD" on a French one.
  std::string labels_of_places(std::string_view letters) const;

 private:
  static std::size_t index(Key key) { return static_cast<std::size_t>(key); }
  bool has(Key key) const { return typed_[index(key)]; }
  bool latin() const { return has(Key::a) && has(Key::z); }

  static constexpr std::size_t key_count = static_cast<std::size_t>(Key::other) + 1;
  std::array<std::array<char32_t, 4>, key_count> characters_{};  // of a place on its levels
  std::bitset<key_count> typed_;                                 // letters and signs that some place types
};

/// The layout of the keyboard in use; a US one until platform/keyboard.h reads another. Main thread only.
KeyboardLayout& keyboard_layout();

}  // namespace ps::gui
