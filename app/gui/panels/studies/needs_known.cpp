#include "gui/panels/studies/needs_known.h"

#include <fmt/format.h>
#include <imgui.h>

#include <string>
#include <vector>

#include "gui/widgets/draw.h"
#include "gui/widgets/widgets.h"
#include "options/option.h"
#include "study/features.h"
#include "study/needs.h"
#include "study/setting_words.h"

namespace ps::gui {
namespace {

/// "shadows (traced)", "reflected rays (Reflection depth: 3)"; what is only on or off has no value behind it.
std::string used_words(const Feature& feature, const Settings& settings) {
  const Option* option = find_option(feature.option);
  if (!option || option->kind == OptionKind::boolean) return std::string(feature.noun);
  const std::string value = option_text(*option, settings);
  if (option->kind == OptionKind::choice) return fmt::format("{} ({})", feature.noun, value);
  return fmt::format("{} ({})", feature.noun, setting_words(fmt::format("{}={}", option->key, value)));
}

/// "lighting, shadows (traced) and highlights"
std::string used_list(const std::vector<std::string>& words) {
  std::string list = words.front();
  for (std::size_t i = 1; i < words.size(); ++i) list += (i + 1 == words.size() ? " and " : ", ") + words[i];
  return list;
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
                               : fmt::format("In this scene the options of {} use {}.", letter, used_list(used)),
                  {Face::bold});
  for (const FeatureShare& share : unused) {
    const std::string text = needs_free_sentence(share);
    quiet_text(text);
    controls().record(fmt::format("free/{}", share.feature.name), text_of(share.reason));
  }
}

}  // namespace ps::gui
