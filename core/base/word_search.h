#pragma once
#include <initializer_list>
#include <string_view>

namespace ps {

/// Whether every word of `wanted` occurs in one of the texts, also as a part of a word and whatever its case (of ASCII
/// letters). Nothing wanted occurs everywhere.
bool has_words(std::string_view wanted, std::initializer_list<std::string_view> texts);

}  // namespace ps
