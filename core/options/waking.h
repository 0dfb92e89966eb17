#pragma once
#include <string>
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
  std::string missing;
  /// Why it cannot act now: "needs textures = on"; empty for an option that acts.
  std::string reason;
};

/// Says of a renderer that it starts something, such as a driver, to find out why it cannot draw. Until known() answers
/// true, suggestions take it for one that can. For the `main` of a program, after add_renderer().
void add_slow_start(Renderer renderer, bool (*known)());
/// Whether it is known why the renderer cannot draw, or that it can.
bool has_started(Renderer renderer);

/// Follows the reasons of an inactive option, or of the choice that is set, to what makes it act: as few settings as
/// possible, and of equally few those that the reasons name first. Empty in all parts for an option that acts.
Waking waking_of(const Option& option, const Settings& settings, const SceneTraits& traits);

/// Sets all of it.
void wake(const Waking& waking, Settings& settings);

/// "needs Shading = Phong", or what is missing.
std::string waking_text(const Waking& waking);

}  // namespace ps
