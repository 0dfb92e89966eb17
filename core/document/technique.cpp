#include "document/technique.h"

#include <memory>

#include <fmt/format.h>

#include "base/check.h"
#include "options/option.h"
#include "options/renderer_kind.h"
#include "options/waking.h"

namespace ps {
namespace {

const std::vector<std::string_view>& settings_of(const TechniqueSettings& settings, PictureWay way) {
  return way == PictureWay::fragments ? settings.fragments : settings.rays;
}

bool knows(const TechniqueChoice& choice, PictureWay way) {
  return way != PictureWay::listing && !settings_of(choice.a, way).empty();
}

const Option& option_in(std::string_view assignment) {
  const Option* option = find_option(assignment.substr(0, assignment.find('=')));
  PS_ASSERT(option, "the table of techniques names options that there are");
  return *option;
}

void apply(const std::vector<std::string_view>& assignments, Settings& settings) {
  for (const std::string_view assignment : assignments) parse_assignment(assignment, settings);
}

/// Makes the options act, by what else they need; false where the scene lacks it.
bool wake_all(const std::vector<std::string_view>& assignments, const SceneTraits& traits, Settings& settings) {
  for (const std::string_view assignment : assignments) {
    const Waking waking = waking_of(option_in(assignment), settings, traits);
    if (!waking.missing.empty()) return false;
    wake(waking, settings);
  }
  return true;
}

/// The pair, whether or not this computer has B's renderer: looking for a graphics driver takes its time.
std::optional<TechniquePair> pair_of(const TechniqueChoice& choice, const Settings& now, const SceneTraits& traits) {
  TechniquePair pair{now, now};
  PictureWay way = picture_way(now.renderer);
  if (!knows(choice, way)) {
    way = knows(choice, PictureWay::rays) ? PictureWay::rays : PictureWay::fragments;
    pair.a.renderer = renderer_for(way);
  }
  apply(settings_of(choice.a, way), pair.a);
  if (!wake_all(settings_of(choice.a, way), traits, pair.a)) return {};
  pair.b = pair.a;
  apply(settings_of(choice.b, way), pair.b);
  return pair;
}

}  // namespace

std::optional<TechniquePair> technique_pair(const TechniqueChoice& choice, const Settings& now,
                                            const SceneTraits& traits) {
  auto pair = pair_of(choice, now, traits);
  if (pair && inactive_value_reason(*find_option("renderer"), pair->b, traits)) return {};
  return pair;
}

std::optional<ShownTechnique> shown_technique(const Document& document, const SceneTraits& traits) {
  if (!document.picture_b.empty()) return {};
  const auto techniques = technique_table();
  for (std::size_t i = 0; i < techniques.size(); ++i)
    for (std::size_t k = 0; k < techniques[i].choices.size(); ++k) {
      const auto pair = pair_of(techniques[i].choices[k], document.a.settings, traits);
      if (pair && pair->a == document.a.settings && pair->b == document.b.settings) return ShownTechnique{i, k};
    }
  return {};
}

std::array<std::string_view, 2> technique_words(const Document& document, const ShownTechnique& shown) {
  const Technique& technique = technique_table()[shown.technique];
  const TechniqueChoice& choice = technique.choices[shown.choice];
  const PictureWay way = picture_way(document.a.settings.renderer);
  std::string_view with = technique.with;
  for (const TechniqueChoice& other : technique.choices)  // A of one choice is B of another
    if (settings_of(other.b, way) == settings_of(choice.a, way)) with = other.label;
  return {with, choice.label};
}

Document with_technique(const Document& now, const Technique& technique, const TechniqueChoice& choice,
                        const std::function<Scene(const std::string& name)>& load) {
  Document then = now;
  auto pair = technique_pair(choice, now.a.settings, scene_traits(now.scene));
  for (std::size_t i = 0; !pair && i < technique.scenes.size(); ++i) {
    const std::string name(technique.scenes[i]);
    Document other = open_document(name, load(name));
    pair = technique_pair(choice, other.a.settings, scene_traits(other.scene));
    if (!pair) continue;
    other.mode = now.mode;
    other.layout = now.layout;
    other.compare = now.compare;
    then = std::move(other);
  }
  if (!pair) throw InputError(fmt::format("No scene shows '{}' on this computer.", choice.label));
  then.a.settings = pair->a;
  then.b.settings = pair->b;
  then.picture_b.clear();
  if (then.compare == CompareMode::only_a || then.compare == CompareMode::only_b)
    then.compare = CompareMode::side_by_side;
  then.before_technique = now.before_technique ? now.before_technique : std::make_shared<const Document>(now);
  return then;
}

Document without_technique(const Document& now) {
  Document then = now.before_technique ? *now.before_technique : now;
  if (!now.before_technique) then.b = then.a;
  then.mode = now.mode;
  then.layout = now.layout;
  // A comparison shows two pictures; the way back is to one of them alone, if that was shown.
  const bool alone = then.compare == CompareMode::only_a || then.compare == CompareMode::only_b;
  if (!alone) then.compare = now.compare;
  return then;
}

}  // namespace ps
