#include "gui/panels/studies/needs_known.h"

#include <fmt/format.h>

#include <string>
#include <vector>

#include "base/sentence.h"
#include "gui/panels/studies/needs_view.h"
#include "gui/widgets/widgets.h"
#include "options/difference_words.h"
#include "options/option.h"
#include "study/features.h"
#include "study/needs.h"

namespace ps::gui {
namespace {

/// "shadows (traced)", "reflected rays (reflection depth 3)"; what is only on or off has no value behind it.
std::string used_words(const Feature& feature, const Settings& settings) {
  const Option* option = find_option(feature.option);
  if (!option || option->kind == OptionKind::boolean) return std::string(feature.noun);
  const std::string value = option_text(*option, settings);
  if (option->kind == OptionKind::choice) return fmt::format("{} ({})", feature.noun, value);
  return fmt::format("{} ({})", feature.noun, setting_words(fmt::format("{}={}", option->key, value)));
}

}  // namespace

void needs_known(const Settings& settings, const SceneTraits& traits, char letter) {
  const NameScope scope("known");
  std::vector<std::string> used;
  std::vector<FeatureShare> unused;
  for (const Feature& feature : features()) {
    if (const auto reason = unused_reason(feature, settings, traits)) {
      FeatureShare& share = unused.emplace_back();
      share.feature = feature;
      share.reason = reason;
    } else {
      used.push_back(used_words(feature, settings));
    }
  }
  value_paragraph("used",
                  used.empty() ? fmt::format("In this scene the options of {} use no feature.", letter)
                               : fmt::format("In this scene the options of {} use {}.", letter, listed(used)),
                  {Face::bold});
  unused_features(unused);
}

}  // namespace ps::gui
