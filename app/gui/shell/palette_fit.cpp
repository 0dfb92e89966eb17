#include "gui/shell/palette_fit.h"

#include <string>

#include "base/word_search.h"

namespace ps::gui {
namespace {

/// Scattered letters of a long word occur in nearly every sentence.
constexpr std::size_t most_scattered_letters = 3;

bool is_one_of(std::string_view wanted, std::string_view words) {
  for (std::size_t comma = 0; comma != std::string_view::npos; words.remove_prefix(comma + 1)) {
    comma = words.find(',');
    if (trimmed(words.substr(0, comma)) == wanted) return true;
    if (comma == std::string_view::npos) break;
  }
  return false;
}

}  // namespace

std::optional<PaletteFit> palette_fit(std::string_view wanted, std::string_view label, std::string_view words) {
  const std::string typed = in_small_letters(trimmed(wanted)), title = in_small_letters(label);
  if (typed.empty()) return PaletteFit::begins_label;
  if (typed == title) return PaletteFit::is_label;
  if (is_one_of(typed, in_small_letters(words))) return PaletteFit::is_word;
  if (title.starts_with(typed)) return PaletteFit::begins_label;
  if (title.find(typed) != std::string::npos) return PaletteFit::in_label;
  if (has_words(typed, {label, words})) return PaletteFit::has_words;
  if (typed.size() <= most_scattered_letters && letters_in_order(typed, label)) return PaletteFit::letters_in_order;
  return {};
}

}  // namespace ps::gui
