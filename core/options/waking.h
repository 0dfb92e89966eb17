#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "options/option.h"

namespace ps {

/// One option with one of its values.
struct OptionValue {
  const Option* option = nullptr;
  OptionNumber value = 0;
};

/// What an option that cannot act needs.
struct Waking {
  /// Other options to set so that it acts, in this order and as few as possible. Empty if no setting helps, because the
  /// scene lacks what the option is about.
  std::vector<OptionValue> settings;
  /// Where no setting helps: what is missing, in the words of the option table: "the scene has no texture".
  std::string_view missing;
};

/// Searches the option table for what makes an inactive option act, or the choice that is set. Of answers that set
/// equally many options, the one whose names the reason has comes first; of numbers, the one nearest to what is set.
/// Empty in both parts for an option that acts.
Waking waking_of(const Option& option, const Settings& settings, const SceneTraits& traits);

/// Sets all of it.
void wake(const Waking& waking, Settings& settings);

/// "acts with Shading = Phong", or what is missing.
std::string waking_text(const Waking& waking);

}  // namespace ps
