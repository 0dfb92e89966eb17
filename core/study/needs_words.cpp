#include "study/needs_words.h"

#include <vector>

#include <fmt/format.h>

namespace ps {
namespace {

constexpr double still_hard_to_see = 0.1, still_visible = 0.25;

using Words = std::vector<std::string>;

/// "a, b and c"
std::string list(const Words& words, std::string_view last = "and") {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "" : i + 1 == words.size() ? fmt::format(" {} ", last) : std::string(", ")) + words[i];
  return text;
}

std::string begun_large(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
  return text;
}

/// "nothing to reflect or refract and no textures"
std::string absent_words(const Needs& needs) {
  Words verbs, others;
  for (const FeatureShare& share : needs.shares) {
    if (!share.absent) continue;
    if (share.feature.verb.empty())
      others.emplace_back(share.feature.absent);
    else
      verbs.emplace_back(share.feature.verb);
  }
  if (!verbs.empty()) others.insert(others.begin(), "nothing to " + list(verbs, "or"));
  return list(others);
}

}  // namespace

std::string scene_subject(std::string_view scene_name) {
  const auto slash = scene_name.rfind('/');
  std::string name(slash == std::string_view::npos ? scene_name : scene_name.substr(slash + 1));
  if (const auto dot = name.find('.'); dot != std::string::npos && dot > 0) name.resize(dot);
  for (char& c : name)
    if (c == '-' || c == '_') c = ' ';
  return name.empty() ? "The scene" : fmt::format("The scene '{}'", begun_large(name));
}

std::string needs_sentence(std::string_view scene_name, const Needs& needs) {
  if (needs.shares.size() != features().size()) return "";
  Words needed, spare, off;
  for (const FeatureShare& share : needs.shares) {
    const std::string noun(share.feature.noun);
    if (share.used)
      (is_needed(share, needs.tolerance) ? needed : spare).push_back(noun);
    else if (!share.absent)
      off.push_back(noun);
  }
  std::string text = needed.empty() ? fmt::format("{} needs none of its features.", scene_subject(scene_name))
                                    : fmt::format("{} needs {}.", scene_subject(scene_name), list(needed));
  const std::string absent = absent_words(needs);
  if (!spare.empty() && !absent.empty())
    text += fmt::format(" It can do without {}; it has {}.", list(spare), absent);
  else if (!spare.empty())
    text += fmt::format(" It can do without {}.", list(spare));
  else if (!absent.empty())
    text += fmt::format(" It has {}.", absent);
  if (!off.empty()) text += fmt::format(" With these settings unused: {}.", list(off));
  return text;
}

std::string keep_sentence() {
  return fmt::format("Keep the settings: nothing that stays within the tolerance saves {:.0f} % of the work.",
                     100 * least_saving);
}

std::string not_enough_sentence(const Needs& needs) {
  return fmt::format("The current settings are not enough: exact ones are closer to the truth by a FLIP of more than "
                     "{:.2g} in some tile. Compared with those, the advice adds {:.2g}.",
                     needs.tolerance, needs.increase);
}

std::string truth_sentence(const Needs& needs) {
  return fmt::format("As it is, the worst tile differs by a FLIP of {:.2g} from the truth, which is {}.{}",
                     needs.default_error, needs.truth,
                     needs.uncertainty > 0 ? fmt::format(" That is uncertain by {:.2g}.", needs.uncertainty) : "");
}

std::string_view tolerance_words(double tolerance) {
  if (tolerance <= 0) return "no difference";
  if (tolerance < still_hard_to_see) return "hard to see";
  return tolerance < still_visible ? "visible" : "obvious";
}

}  // namespace ps
