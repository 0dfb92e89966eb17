#pragma once
#include <initializer_list>
#include <string>
#include <string_view>

namespace ps {

/// Whether every word of `wanted` occurs in one of the texts, also as a part of a word and whatever its case (of ASCII
/// letters). An empty `wanted` occurs everywhere.
bool has_words(std::string_view wanted, std::initializer_list<std::string_view> texts);

/// Whether the letters of `wanted` occur in `text` in this order, with others between them, whatever their case (of
/// ASCII letters).
bool letters_in_order(std::string_view wanted, std::string_view text);

/// The text without the spaces at both of its ends.
std::string_view trimmed(std::string_view text);

/// The text with small ASCII letters; as many bytes.
std::string in_small_letters(std::string_view text);

}  // namespace ps
