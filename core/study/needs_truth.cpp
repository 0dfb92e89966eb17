#include "study/needs_truth.h"

#include <algorithm>

#include <fmt/format.h>

#include "options/option.h"
#include "options/renderer_kind.h"
#include "study/features.h"

namespace ps {
namespace {

constexpr int enough_bounces = 12;

std::vector<SweepPoint> tried_pictures(const Settings& base, const SceneTraits& traits) {
  std::vector<SweepPoint> points(1);
  points.front().value = base;
  for (const Feature& feature : features())
    if (!unused_reason(feature, base, traits)) points.emplace_back().value = without(feature, base);
  for (const Saving& saving : savings(base, traits)) {
    points.emplace_back().value = base;
    parse_option(*find_option(saving.option), saving.value, points.back().value);
  }
  return points;
}

}  // namespace

NeedsTruth needs_truth(const Settings& base, const SceneTraits& traits, const View& view) {
  Settings asked = base;
  if (draws_fragments(base.renderer) && base.shadows == Shadows::traced) asked.shadows = Shadows::none;
  NeedsTruth truth{plan_reference(tried_pictures(asked, traits), asked, traits, view, {}), base};
  int& bounces = truth.plan.settings.reflection_depth;
  bounces = std::min(bounces, std::max(base.reflection_depth, enough_bounces));
  for (std::string& exact : truth.plan.exact)
    if (exact.starts_with("reflection-depth=")) exact = fmt::format("reflection-depth={}", bounces);
  for (const Option* option : truth.plan.swept)
    if (option->truth.kind == TruthKind::exact && option->key != "precision")
      option->set(truth.exact, option->get(truth.plan.settings));
  return truth;
}

}  // namespace ps
