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

}  // namespace ps
