#include "study/standing.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "base/check.h"
#include "options/robust_rays.h"

namespace ps {
namespace {

bool shows_another_picture(const Settings& settings, const ReferencePlan& plan, const SceneTraits& traits) {
  return std::any_of(plan.swept.begin(), plan.swept.end(), [&](const Option* option) {
    return option->truth.kind == TruthKind::other_picture && option->get(settings) != option->get(plan.settings) &&
           !inactive_reason(*option, settings, traits);
  });
}

/// What is not swept may differ by what robust_rays() does to the truth: that changes no more than rounding.
bool has_the_settings_of_the_truth(const Settings& settings, const ReferencePlan& plan) {
  const Settings robust = robust_rays(settings);
  const auto all = option_table();
  return plan.samples == 1 && std::all_of(all.begin(), all.end(), [&](const Option& option) {
           const bool swept = std::find(plan.swept.begin(), plan.swept.end(), &option) != plan.swept.end();
           const OptionNumber true_value = option.get(plan.settings);
           return option.effect == OptionEffect::speed || option.get(settings) == true_value ||
                  (!swept && option.get(robust) == true_value);
         });
}

}  // namespace

std::vector<Standing> standings(std::span<const SweepPoint> points, const ReferencePlan& plan,
                                const SceneTraits& traits) {
  std::vector<Standing> all;
  for (const SweepPoint& point : points)
    all.push_back(shows_another_picture(point.value, plan, traits)                   ? Standing::other_picture
                  : !point.scene && has_the_settings_of_the_truth(point.value, plan) ? Standing::truth
                                                                                     : Standing::compared);
  const auto has = [&](Standing standing) { return std::find(all.begin(), all.end(), standing) != all.end(); };
  if (!has(Standing::compared))
    std::replace(all.begin(), all.end(), Standing::truth,
                 has(Standing::other_picture) ? Standing::other_picture : Standing::compared);
  return all;
}

}  // namespace ps
