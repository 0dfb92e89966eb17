#pragma once
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "engine/lesson_search.h"

/// Parts of LessonIndex that do not depend on lessons. All texts and words are in small letters.

namespace ps {

/// A word's place in a text.
struct FoundWord {
  TextRange range;
  bool begins_word = false;  ///< not behind a letter of the same word
};

/// The first place where the word begins a word; else its first place within one. `whole`: it must end there, too.
enum class WordPart { whole, any };
std::optional<FoundWord> find_word(std::string_view text, std::string_view word, WordPart part);

/// Adds the words of at least 3 letters; digits count as letters.
void add_words(std::string_view text, std::set<std::string>& words);

/// About 100 bytes of `shown` around a place, from blank to blank, with "…" where something was left out.
std::string text_around(std::string_view shown, const TextRange& place);

}  // namespace ps
