#include "engine/words_in_text.h"

#include <algorithm>

namespace ps {
namespace {

constexpr std::size_t before_word = 40, behind_word = 64;  // bytes of text around a word

/// Bytes of UTF-8 beyond ASCII count as letters.
bool in_word(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
         static_cast<unsigned char>(c) > 127;
}

}  // namespace

std::optional<FoundWord> find_word(std::string_view text, std::string_view word, WordPart part) {
  std::optional<FoundWord> within;
  for (std::size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    const bool begins = at == 0 || !in_word(text[at - 1]), ends = end == text.size() || !in_word(text[end]);
    if (begins && (ends || part == WordPart::any)) return FoundWord{{at, end}, true};
    if (part == WordPart::any && !within) within = FoundWord{{at, end}, false};
  }
  return within;
}

void add_words(std::string_view text, std::set<std::string>& words) {
  constexpr std::size_t least_letters = 3;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const std::size_t begin = at;
    while (at < text.size() && in_word(text[at])) ++at;
    if (at - begin >= least_letters) words.emplace(text.substr(begin, at - begin));
  }
}

std::string text_around(std::string_view shown, const TextRange& place) {
  std::size_t begin = place.begin > before_word ? shown.find(' ', place.begin - before_word) + 1 : 0;
  begin = std::min(begin, place.begin);
  while (begin > 0 && shown[begin - 1] != ' ') --begin;
  std::size_t end = shown.size();
  if (place.end + behind_word < shown.size()) {
    end = shown.rfind(' ', place.end + behind_word);
    if (end == std::string_view::npos || end < place.end) end = std::min(shown.find(' ', place.end), shown.size());
  }
  std::string around = begin > 0 ? "… " : "";
  around += shown.substr(begin, end - begin);
  if (end < shown.size()) around += " …";
  return around;
}

}  // namespace ps
