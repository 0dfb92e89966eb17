#include "options/waking.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "base/number_text.h"
#include "options/listing.h"

namespace ps {
namespace {

constexpr std::size_t most_settings = 4;  // that are searched for; no row of the table needs as many

using Reason = std::optional<std::string_view>;

Reason reason_of(const Option& option, const Settings& settings, const SceneTraits& traits) {
  if (const Reason reason = inactive_reason(option, settings, traits)) return reason;
  return inactive_value_reason(option, settings, traits);
}

/// The default, what a sweep tries (the nearest first), and the smallest values: more of a number costs more.
std::vector<OptionNumber> numbers_of(const Option& option, OptionNumber now) {
  std::vector<OptionNumber> swept;
  for (std::string_view rest = option.sweep_values; !rest.empty();) {
    const std::string_view one = rest.substr(0, rest.find(','));
    if (const auto number = parse_number(one)) swept.push_back(*number);
    rest.remove_prefix(std::min(rest.size(), one.size() + 1));
  }
  const auto away = [&](OptionNumber value) {
    return option.scale == OptionScale::logarithmic ? std::abs(std::log(value) - std::log(now)) : std::abs(value - now);
  };
  std::stable_sort(swept.begin(), swept.end(), [&](auto one, auto other) { return away(one) < away(other); });
  std::vector<OptionNumber> values{option.default_value()};
  values.insert(values.end(), swept.begin(), swept.end());
  if (option.kind == OptionKind::integer) values.insert(values.end(), {option.minimum, option.minimum + 1});
  return values;
}

std::vector<OptionNumber> values_of(const Option& option, OptionNumber now) {
  switch (option.kind) {
  case OptionKind::boolean:
    return {1, 0};
  case OptionKind::choice: {
    std::vector<OptionNumber> values(option.choices.size());
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<OptionNumber>(i);
    return values;
  }
  case OptionKind::integer:
  case OptionKind::real:
    return numbers_of(option, now);
  }
  return {};
}

/// Whether a reason has a key in its words: "depth-buffer" in "needs a depth buffer".
bool mentions(std::string_view reason, std::string_view key) {
  const auto same = [](char one, char other) { return one == other || (one == ' ' && other == '-'); };
  return std::search(reason.begin(), reason.end(), key.begin(), key.end(), same) != reason.end();
}

/// How well a setting answers a reason: above all it is the option that the reason names.
int answers(std::string_view reason, const Option& option, OptionNumber value) {
  int score = mentions(reason, option.key) ? 4 : 0;
  if (option.kind == OptionKind::choice && mentions(reason, option.choices[static_cast<std::size_t>(value)].key))
    score += 2;
  return score;
}

/// Does the listing show nothing of the scene? Then it is not suggested.
bool shows_nothing(const Settings& settings, const SceneTraits& traits) {
  return runs_listing(settings.renderer) && listing_of(settings, traits).listing->suits(traits, settings) == 0;
}

/// Whether a listing may be asked to draw in place of a renderer: it shows less of most scenes.
enum class Listings { as_set, any };

/// Settings on the way to those under which the option acts.
struct Stage {
  Settings settings;
  std::vector<OptionValue> set;
  Reason reason;  ///< nothing: the option acts
  int score = 0;
};

/// Of a scene that has everything.
SceneTraits all_traits() {
  SceneTraits all;
  for (bool SceneTraits::*const trait : {&SceneTraits::spheres,
                                         &SceneTraits::triangles,
                                         &SceneTraits::vertex_normals,
                                         &SceneTraits::textures,
                                         &SceneTraits::normal_maps,
                                         &SceneTraits::height_maps,
                                         &SceneTraits::reflective,
                                         &SceneTraits::specular,
                                         &SceneTraits::casting_lights,
                                         &SceneTraits::solids,
                                         &SceneTraits::csg,
                                         &SceneTraits::transparent,
                                         &SceneTraits::attenuated,
                                         &SceneTraits::point_lights,
                                         &SceneTraits::patches,
                                         &SceneTraits::light_maps,
                                         &SceneTraits::opacity_maps,
                                         &SceneTraits::reflection_maps,
                                         &SceneTraits::mirrors,
                                         &SceneTraits::canvas_items,
                                         &SceneTraits::canvas_triangles,
                                         &SceneTraits::canvas_intensities,
                                         &SceneTraits::canvas_gradients,
                                         &SceneTraits::tinted,
                                         &SceneTraits::coloured_lights,
                                         &SceneTraits::odd_highlights,
                                         &SceneTraits::any_transparency,
                                         &SceneTraits::one_sided,
                                         &SceneTraits::dynamic})
    all.*trait = true;
  all.light_count = std::numeric_limits<std::size_t>::max();
  return all;
}

/// Whether it is the scene that lacks something: in another one the same settings give another reason, or none.
bool is_of_scene(const Option& option, const Stage& stage) {
  static const SceneTraits all = all_traits();
  if (stage.reason == renderer_kind(stage.settings.renderer).unread) return false;
  return stage.reason && reason_of(option, stage.settings, all) != stage.reason;
}

/// All stages that one more setting leads to. What cannot be set, because the scene lacks what that is about, goes to
/// `missing`.
void add_next(const Option& wanted, const Stage& from, const SceneTraits& traits, Listings listings,
              std::vector<Stage>& next, std::string_view& missing) {
  for (const Option& option : option_table()) {
    if (&option == &wanted) continue;
    if (std::any_of(from.set.begin(), from.set.end(), [&](const OptionValue& set) { return set.option == &option; }))
      continue;
    const OptionNumber now = option.get(from.settings);
    for (const OptionNumber value : values_of(option, now)) {
      if (value == now) continue;
      Settings settings = from.settings;
      option.set(settings, value);
      const Reason reason = reason_of(wanted, settings, traits);
      if (reason == from.reason) continue;
      if (listings == Listings::as_set && runs_listing(settings.renderer) && !runs_listing(from.settings.renderer))
        continue;
      if (shows_nothing(settings, traits)) {
        if (missing.empty()) missing = "the listings that use it show nothing of this scene";
        continue;
      }
      if (const Reason own = reason_of(option, settings, traits)) {
        if (is_of_scene(option, {settings, {}, own})) missing = *own;
        continue;
      }
      Stage stage{settings, from.set, reason, from.score + answers(*from.reason, option, value)};
      stage.set.push_back({&option, value});
      next.push_back(std::move(stage));
    }
  }
}

std::string value_words(const OptionValue& set) {
  const Option& option = *set.option;
  if (option.kind == OptionKind::boolean) return fmt::format("{} {}", option.label, set.value != 0 ? "on" : "off");
  if (option.kind == OptionKind::choice)
    return fmt::format("{} = {}", option.label, option.choices[static_cast<std::size_t>(set.value)].label);
  return fmt::format("{} = {}", option.label, set.value);
}

Waking search(const Option& option, const Settings& settings, const SceneTraits& traits, Listings listings) {
  std::vector<Stage> stages{{settings, {}, reason_of(option, settings, traits), 0}};
  if (!stages.front().reason) return {};
  std::string_view missing = *stages.front().reason, in_the_way;
  bool of_scene = is_of_scene(option, stages.front());
  std::set<std::string_view> met{missing};
  for (std::size_t count = 1; count <= most_settings && !stages.empty(); ++count) {
    std::vector<Stage> next;
    for (const Stage& stage : stages) add_next(option, stage, traits, listings, next, in_the_way);
    std::stable_sort(next.begin(), next.end(), [](const Stage& a, const Stage& b) { return a.score > b.score; });
    const auto acts = std::find_if(next.begin(), next.end(), [](const Stage& stage) { return !stage.reason; });
    if (acts != next.end()) return {acts->set, {}};
    // Of all ways to the same next reason the best goes on.
    std::erase_if(next, [&](const Stage& stage) { return !met.insert(*stage.reason).second; });
    for (const Stage& stage : next) {
      if (of_scene || !is_of_scene(option, stage)) continue;
      of_scene = true;
      missing = *stage.reason;
    }
    stages = std::move(next);
  }
  return {{}, of_scene || in_the_way.empty() ? missing : in_the_way};
}

}  // namespace

Waking waking_of(const Option& option, const Settings& settings, const SceneTraits& traits) {
  Waking waking = search(option, settings, traits, Listings::as_set);
  if (!waking.missing.empty()) waking = search(option, settings, traits, Listings::any);
  return waking;
}

void wake(const Waking& waking, Settings& settings) {
  for (const OptionValue& set : waking.settings) set.option->set(settings, set.value);
}

std::string waking_text(const Waking& waking) {
  if (waking.settings.empty()) return std::string(waking.missing);
  std::string text;
  for (const OptionValue& set : waking.settings) text += (text.empty() ? "acts with " : ", ") + value_words(set);
  return text;
}

}  // namespace ps
