#include "study/needs_words.h"

#include <algorithm>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/sentence.h"

namespace ps {
namespace {

constexpr double still_hard_to_see = 0.1, still_visible = 0.25;

using Words = std::vector<std::string>;

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
  if (!verbs.empty()) others.insert(others.begin(), "nothing to " + listed(verbs, "or"));
  return listed(others);
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
                                    : fmt::format("{} needs {}.", scene_subject(scene_name), listed(needed));
  const std::string absent = absent_words(needs);
  if (!spare.empty() && !absent.empty())
    text += fmt::format(" It can do without {}; it has {}.", listed(spare), absent);
  else if (!spare.empty())
    text += fmt::format(" It can do without {}.", listed(spare));
  else if (!absent.empty())
    text += fmt::format(" It has {}.", absent);
  if (!off.empty()) text += fmt::format(" With these settings unused: {}.", listed(off));
  return text;
}

namespace {

/// A reason about "it", said of these nouns: "only the ray tracer uses them".
std::string reason_for(const Words& nouns, std::string reason) {
  constexpr std::string_view one = " it", several = " them";
  const bool is_one = nouns.size() == 1 && !nouns.front().ends_with('s');
  if (!is_one && reason.ends_with(one)) reason.replace(reason.size() - one.size(), one.size(), several);
  return reason;
}

}  // namespace

std::string unused_sentence(std::span<const FeatureShare> shares) {
  std::vector<std::pair<std::string, Words>> reasons;  // in the order of their first feature
  for (const FeatureShare& share : shares) {
    if (share.used) continue;
    const std::string reason = text_of(share.reason);
    auto same = std::find_if(reasons.begin(), reasons.end(), [&](const auto& one) { return one.first == reason; });
    if (same == reasons.end()) same = reasons.insert(same, {reason, {}});
    same->second.emplace_back(share.feature.noun);
  }
  Words parts;
  for (const auto& [reason, nouns] : reasons)
    parts.push_back(fmt::format("{} ({})", listed(nouns), reason_for(nouns, reason)));
  return parts.empty() ? "" : fmt::format("Not in use: {}.", fmt::join(parts, "; "));
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
