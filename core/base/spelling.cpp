#include "base/spelling.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace ps {
namespace {

constexpr std::size_t longest_typed = 64;  // letters; a longer word is not a typing error

}  // namespace

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

std::string_view similar_word(std::string_view word, std::span<const std::string_view> known) {
  constexpr std::size_t least_part = 4;  // letters; shorter ones are part of nearly anything
  const std::string_view asked = word.substr(0, longest_typed), nearest = nearest_word(asked, known);
  if (asked.empty() || nearest.empty()) return {};
  const std::size_t letters = std::max(asked.size(), nearest.size());
  if (3 * edit_distance(nearest, asked) <= letters + 2) return nearest;
  const auto is_part = [](std::string_view part, std::string_view of) {
    return part.size() >= least_part && of.find(part) != std::string_view::npos;
  };
  std::vector<std::string_view> parts;
  for (const std::string_view candidate : known)
    if (is_part(candidate, asked) || is_part(asked, candidate)) parts.push_back(candidate);
  return nearest_word(asked, parts);
}

std::string did_you_mean(std::string_view word, std::span<const std::string_view> known, std::string_view otherwise) {
  const std::string_view similar = similar_word(word, known);
  return similar.empty() ? std::string(otherwise) : "; did you mean '" + std::string(similar) + "'?";
}

std::string expected_word(std::string_view word, std::span<const std::string_view> known) {
  const std::string_view similar = similar_word(word, known);
  return similar.empty() ? fmt::format("one of {}", fmt::join(known, " ")) : fmt::format("'{}'", similar);
}

std::string_view nearest_word(std::string_view word, std::span<const std::string_view> known) {
  const std::string_view asked = word.substr(0, longest_typed);
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
