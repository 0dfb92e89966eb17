#include "base/word_search.h"

#include <algorithm>

namespace ps {
namespace {

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool occurs(std::string_view word, std::string_view text) {
  return std::search(text.begin(), text.end(), word.begin(), word.end(),
                     [](char a, char b) { return lower(a) == lower(b); }) != text.end();
}

}  // namespace

bool has_words(std::string_view wanted, std::initializer_list<std::string_view> texts) {
  while (true) {
    const auto begin = wanted.find_first_not_of(' ');
    if (begin == std::string_view::npos) return true;
    wanted.remove_prefix(begin);
    const std::string_view word = wanted.substr(0, wanted.find(' '));
    wanted.remove_prefix(word.size());
    if (std::none_of(texts.begin(), texts.end(), [&](std::string_view text) { return occurs(word, text); }))
      return false;
  }
}

bool letters_in_order(std::string_view wanted, std::string_view text) {
  std::size_t at = 0;
  for (const char c : text)
    if (at < wanted.size() && lower(c) == lower(wanted[at])) ++at;
  return at == wanted.size();
}

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(' ');
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

std::string in_small_letters(std::string_view text) {
  std::string small(text);
  std::transform(small.begin(), small.end(), small.begin(), lower);
  return small;
}

}  // namespace ps
