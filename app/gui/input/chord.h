#pragma once
#include <string>
#include <string_view>

#include "gui/input/key.h"

namespace ps::gui {

/// A key with modifiers.
struct Chord {
  Key key = Key::none;
  bool ctrl = false, shift = false, alt = false;
  bool operator==(const Chord&) const = default;
};
/// "Ctrl+Shift+Z", "?", "PageDown", "F11", "Left", "[", "`". Throws InputError for an unknown name.
Chord parse_chord(std::string_view text);
/// The text that parse_chord reads back; "" for none.
std::string chord_text(const Chord& chord);
/// Its beginning, without the key: "Ctrl+Shift+"; "" without modifiers.
std::string chord_modifiers(const Chord& chord);

}  // namespace ps::gui
