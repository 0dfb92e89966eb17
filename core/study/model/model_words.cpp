#include "study/model/model_words.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/sentence.h"
#include "study/model/model_search.h"

namespace ps {
namespace {

constexpr std::size_t most_parts = 3;  ///< that one sentence names

double greatest_share(const ModelSaving& saving) { return std::max(saving.work, saving.bytes); }

/// "71 % less work"; empty where the change rounds to none.
std::string share_words(std::uint64_t before, std::uint64_t after, std::string_view less, std::string_view what) {
  if (before == 0) return "";
  const double share = 100 * (1 - static_cast<double>(after) / static_cast<double>(before));
  if (share < 0.5) return share > -0.5 ? "" : fmt::format("{:.0f} % more {}", -share, what);
  return fmt::format("{:.0f} % {} {}", share < 99.5 ? share : 99, less, what);
}

/// "all three objects and the light"
std::string shown_things(const ModelNeeds& needs) {
  std::string objects = model::part_of_all(needs.objects, needs.objects, "object", "objects");
  if (needs.lights == 0) return objects;
  return fmt::format("{} and {}", objects, model::part_of_all(needs.lights, needs.lights, "light", "lights"));
}

std::string saved_words(const ModelNeeds& needs) {
  std::string text;
  for (const std::string& words : {share_words(needs.default_work, needs.work, "less", "work"),
                                   share_words(needs.default_bytes, needs.bytes, "fewer", "bytes")})
    if (!words.empty()) text += words + ", ";
  return text + (needs.change.rmse > 0 ? fmt::format("RMSE {:.2g} of 255", needs.change.rmse) : "the same picture");
}

}  // namespace

std::vector<const ModelSaving*> greatest_first(const ModelNeeds& needs) {
  std::vector<const ModelSaving*> savings;
  for (const ModelSaving& saving : needs.savings) savings.push_back(&saving);
  std::stable_sort(savings.begin(), savings.end(),
                   [](const ModelSaving* a, const ModelSaving* b) { return greatest_share(*a) > greatest_share(*b); });
  return savings;
}

std::string model_sentence(const ModelNeeds& needs) {
  if (needs.savings.empty())
    return needs.objects == 0
               ? "Nothing can go: there are no objects, and what is drawn on the canvas stays."
               : fmt::format(
                     "Nothing can go: {} show{}, and no smaller model that saves {:.0f} % stays within the tolerance.",
                     shown_things(needs), needs.objects + needs.lights == 1 ? "s" : "", 100 * least_saving);
  const std::vector<const ModelSaving*> savings = greatest_first(needs);
  const std::size_t named = savings.size() > most_parts ? most_parts - 1 : savings.size();
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < named; ++i)
    parts.push_back(savings[i]->goes + (savings[i]->kept.empty() ? "" : fmt::format(" ({})", savings[i]->kept)));
  if (named < savings.size()) parts.push_back(fmt::format("{} more parts", model::number_word(savings.size() - named)));
  return fmt::format("{} can go: {}.", begun_large(listed(parts)), saved_words(needs));
}

std::string views_words(std::size_t views) {
  return views == 1 ? "from one view" : fmt::format("from {} views", views);
}

}  // namespace ps
