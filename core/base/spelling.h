#pragma once
#include <span>
#include <string>
#include <string_view>

namespace ps {

/// Number of single-letter insertions, deletions and replacements that turn `a` into `b` (Levenshtein's distance).
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The word of `known` with the least edit distance to `word` (the first of equals); empty if `known` is empty.
std::string_view nearest_word(std::string_view word, std::span<const std::string_view> known);

/// The word for a message: as it is, or its first 60 bytes and "..." where it is longer.
std::string shown_start(std::string_view word);

}  // namespace ps
