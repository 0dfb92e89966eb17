#pragma once
#include <span>
#include <string>
#include <string_view>

namespace ps {

/// Number of single-letter insertions, deletions and replacements that turn `a` into `b` (Levenshtein's distance).
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The word of `known` that `word` may have been meant for: the nearest one, if hardly more than a third of its
/// letters differ or one of the two is part of the other; else empty.
std::string_view similar_word(std::string_view word, std::span<const std::string_view> known);

/// "; did you mean 'WORD'?" if there is a similar word, else `otherwise`, which says where all are listed.
std::string did_you_mean(std::string_view word, std::span<const std::string_view> known, std::string_view otherwise);

/// The words expected where `word` was found: "'WORD'" if there is a similar word, else "one of" all of them.
std::string expected_word(std::string_view word, std::span<const std::string_view> known);

/// The word of `known` with the least edit distance to `word` (the first of equals); empty if `known` is empty.
std::string_view nearest_word(std::string_view word, std::span<const std::string_view> known);

/// The word for a message: as it is, or its first 60 bytes and "..." where it is longer.
std::string shown_start(std::string_view word);

}  // namespace ps
