#include "base/spelling.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace ps {

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0]++;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t substitution = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({row[j] + 1, row[j + 1] + 1, substitution});
    }
  }
  return row.back();
}

std::string_view nearest_word(std::string_view word, std::span<const std::string_view> known) {
  const std::string_view asked = word.substr(0, 64);  // nobody mistypes a word longer than this
  const auto nearest = std::min_element(known.begin(), known.end(), [&](std::string_view a, std::string_view b) {
    return edit_distance(a, asked) < edit_distance(b, asked);
  });
  return nearest == known.end() ? std::string_view{} : *nearest;
}

std::string shown_start(std::string_view word) {
  constexpr std::size_t longest = 60;
  return word.size() <= longest ? std::string(word) : std::string(word.substr(0, longest)) + "...";
}

}  // namespace ps
