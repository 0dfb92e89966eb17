#pragma once
#include <optional>
#include <string_view>

namespace ps::gui {

/// How well a line of the palette fits what was typed. The best come first.
enum class PaletteFit {
  is_label,          ///< it is the whole label
  is_word,           ///< it is one of the words that people use for it
  begins_label,      ///< the label begins with it
  in_label,          ///< the label has it in one piece
  has_words,         ///< each of its words stands somewhere
  letters_in_order,  ///< three letters at most, with others between them
};

/// The fit of `wanted` to a line with this label and, separated by commas, these other words; absent where it does not
/// fit. The case of ASCII letters does not matter; an empty `wanted` fits every line.
std::optional<PaletteFit> palette_fit(std::string_view wanted, std::string_view label, std::string_view words);

}  // namespace ps::gui
