#include "options/waking.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>

#include "options/listing.h"

namespace ps {
namespace {

constexpr std::size_t most_kept = 8;  // on the way; no row of the table needs as many

/// Whether a listing may be asked to draw in place of a renderer: it shows less of most scenes.
enum class Listings { as_set, any };

using Steps = std::vector<OptionValue>;

std::map<Renderer, bool (*)()>& slow_starts() {
  static std::map<Renderer, bool (*)()> all;
  return all;
}

std::optional<IdleReason> reason_of(const Option& option, const Settings& settings, const SceneTraits& traits) {
  if (const auto reason = inactive_reason(option, settings, traits)) return reason;
  if (option.key == "renderer" && !has_started(settings.renderer)) return {};
  return inactive_value_reason(option, settings, traits);
}

/// Does the listing show nothing of the scene? Then it is not suggested.
bool shows_nothing(const Settings& settings, const SceneTraits& traits) {
  return runs_listing(settings.renderer) && listing_of(settings, traits).listing->suits(traits, settings) <= 0;
}

void add_choices(const Option& option, Steps& steps) {
  for (std::size_t i = 0; i < option.choices.size(); ++i) steps.push_back({&option, static_cast<OptionNumber>(i)});
}

/// Follows reasons: what one needs is set, and before it what that needs itself.
class Resolver {
 public:
  Resolver(const SceneTraits& traits, Listings listings) : traits_(traits), listings_(listings) {}

  /// The fewest settings under which the option acts; of equally few, the ones that reasons name first.
  /// `kept`: options that must stay as they are.
  std::optional<Steps> steps_to(const Option& option, const Settings& settings, std::vector<const Option*> kept) {
    const auto reason = reason_of(option, settings, traits_);
    if (!reason) return Steps{};
    note_missing(*reason);
    if (kept.size() > most_kept) return {};
    kept.push_back(&option);
    std::optional<Steps> best;
    for (const OptionValue& set : answers_to(*reason, settings)) {
      if (std::find(kept.begin(), kept.end(), set.option) != kept.end()) continue;
      auto steps = steps_by(option, *reason, set, settings, kept);
      if (steps && (!best || steps->size() < best->size())) best = std::move(steps);
    }
    return best;
  }

  /// The first reason on the way that no setting answers.
  const std::string& missing() const { return missing_.empty() ? in_the_way_ : missing_; }

 private:
  void note_missing(const IdleReason& reason) {
    if (missing_.empty() && reason.kind() == IdleReason::Kind::missing) missing_ = reason.text();
  }

  /// The settings that begin with making this one possible.
  std::optional<Steps> steps_by(const Option& option, const IdleReason& reason, const OptionValue& set,
                                Settings settings, std::vector<const Option*> kept) {
    if (set.option->get(settings) == set.value) return {};
    set.option->set(settings, set.value);
    if (reason.kind() != IdleReason::Kind::setting) {
      const auto next = reason_of(option, settings, traits_);
      const bool another_listing = set.option->key == "renderer" && runs_listing(settings.renderer);
      if (next) note_missing(*next);
      if (next && next->kind() != IdleReason::Kind::setting && !another_listing) return {};
    }
    if (shows_nothing(settings, traits_)) {
      if (in_the_way_.empty()) in_the_way_ = "the listings that use it show nothing of this scene";
      return {};
    }
    auto steps = steps_to(*set.option, settings, kept);
    if (!steps) return {};
    steps->push_back(set);
    for (const OptionValue& each : *steps) {
      each.option->set(settings, each.value);
      kept.push_back(each.option);
    }
    const auto rest = steps_to(option, settings, kept);
    if (!rest) return {};
    steps->insert(steps->end(), rest->begin(), rest->end());
    return steps;
  }

  Steps answers_to(const IdleReason& reason, const Settings& settings) const {
    Steps answers;
    for (const Need& need : reason.needs()) answers.push_back({find_option(need.option), need.value});
    if (reason.kind() == IdleReason::Kind::setting) return answers;
    // Another renderer may do without the thing that a scene lacks.
    if (runs_listing(settings.renderer)) add_choices(*find_option("listing"), answers);
    add_choices(*find_option("renderer"), answers);
    if (listings_ == Listings::as_set && !runs_listing(settings.renderer))
      std::erase_if(answers, [](const OptionValue& set) { return runs_listing(static_cast<Renderer>(set.value)); });
    return answers;
  }

  const SceneTraits& traits_;
  const Listings listings_;
  std::string missing_, in_the_way_;
};

std::string value_words(const OptionValue& set) {
  const Option& option = *set.option;
  if (option.kind == OptionKind::boolean) return fmt::format("{} {}", option.label, set.value != 0 ? "on" : "off");
  if (option.kind == OptionKind::choice)
    return fmt::format("{} = {}", option.label, option.choices[static_cast<std::size_t>(set.value)].label);
  return fmt::format("{} = {}", option.label, set.value);
}

/// Drops settings that only the renderer before the last one needed.
Steps without_needless(Steps steps, const Option& option, const Settings& settings, const SceneTraits& traits) {
  for (std::size_t i = 0; i < steps.size();) {
    Waking less;
    for (std::size_t k = 0; k < steps.size(); ++k)
      if (k != i) less.settings.push_back(steps[k]);
    Settings then = settings;
    wake(less, then);
    if (reason_of(option, then, traits))
      ++i;
    else
      steps = less.settings;
  }
  return steps;
}

}  // namespace

void add_slow_start(Renderer renderer, bool (*known)()) { slow_starts()[renderer] = known; }

bool has_started(Renderer renderer) {
  const auto found = slow_starts().find(renderer);
  return found == slow_starts().end() || found->second();
}

Waking waking_of(const Option& option, const Settings& settings, const SceneTraits& traits) {
  const auto reason = reason_of(option, settings, traits);
  if (!reason) return {};
  Waking waking;
  waking.reason = reason->text();
  for (const Listings listings : {Listings::as_set, Listings::any}) {
    Resolver resolver(traits, listings);
    if (const auto steps = resolver.steps_to(option, settings, {})) {
      waking.settings = without_needless(*steps, option, settings, traits);
      waking.missing.clear();
      return waking;
    }
    waking.missing = resolver.missing();
  }
  if (waking.missing.empty()) waking.missing = waking.reason;
  return waking;
}

void wake(const Waking& waking, Settings& settings) {
  for (const OptionValue& set : waking.settings) set.option->set(settings, set.value);
}

std::string waking_text(const Waking& waking) {
  if (waking.settings.empty()) return waking.missing;
  std::string text;
  for (const OptionValue& set : waking.settings) text += (text.empty() ? "needs " : ", ") + value_words(set);
  return text;
}

}  // namespace ps
