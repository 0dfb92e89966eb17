#include "inspect/parting/parting_parts.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "options/option.h"

namespace ps::parting {
namespace {

/// A listing and a kernel may do the same sums in another order.
constexpr double other_order = 1e-9;

const Option& option_named(std::string_view key) {
  const Option* option = find_option(key);
  PS_ASSERT(option, "causes name options by their keys");
  return *option;
}

/// Has the option a value with which this side acts on it?
bool acts_on(const StoryPair& c, const StorySide& side, const Option& option) {
  return !inactive_reason(option, side.settings, c.traits) && !inactive_value_reason(option, side.settings, c.traits);
}

/// As a person has set it: a listing's story is compared in the settings of the renderer whose steps it takes.
std::string value_text(const Option& option, const StorySide& side) {
  if (option.key == "renderer" && side.story.listing)
    return std::string(renderer_kind(renderer_for(PictureWay::listing)).key);
  return option_text(option, side.settings);
}

}  // namespace

double StoryPair::tolerance() const {
  if (a.story.renderer != b.story.renderer) return std::max(slack, 2e-3);
  for (const std::string_view key : {"precision", "self-hit", "shadow-epsilon", "reflection-epsilon", "epsilon-unit",
                                     "sphere-test", "triangle-test", "sample-position"})
    if (explains(*this, key)) return std::max(slack, 1e-4);
  return std::max(slack, with_listing() ? other_order : 0.0);
}

bool StoryPair::same(double x, double y) const {
  if (x == y || (std::isnan(x) && std::isnan(y))) return true;
  return std::abs(x - y) <= tolerance() * std::max({1.0, std::abs(x), std::abs(y)});
}

bool StoryPair::same(const Vec3d& x, const Vec3d& y) const {
  return same(x.x, y.x) && same(x.y, y.y) && same(x.z, y.z);
}

bool explains(const StoryPair& c, std::string_view key) {
  const Option& option = option_named(key);
  const OptionNumber in_a = option.get(c.a.settings), in_b = option.get(c.b.settings);
  if (in_a == in_b) return false;
  const bool acts_a = acts_on(c, c.a, option), acts_b = acts_on(c, c.b, option);
  if (acts_a && acts_b) return true;
  return (acts_a && in_a != option.default_value()) || (acts_b && in_b != option.default_value());
}

std::string option_difference(const StoryPair& c, std::string_view key) {
  const Option& option = option_named(key);
  const bool acts_a = acts_on(c, c.a, option), acts_b = acts_on(c, c.b, option);
  if (acts_a == acts_b)
    return fmt::format("{} is {} in A and {} in B", key, value_text(option, c.a), value_text(option, c.b));
  return fmt::format("{} is {} in {}, and {} does not use it", key, value_text(option, acts_a ? c.a : c.b),
                     acts_a ? "A" : "B", acts_a ? "B" : "A");
}

std::string because(const StoryPair& c, std::initializer_list<std::string_view> keys) {
  for (const std::string_view key : keys)
    if (explains(c, key)) return ": " + option_difference(c, key);
  return {};
}

std::string because(const StoryPair& c, const Option* option) {
  return option ? ": " + option_difference(c, option->key) : "";
}

namespace {

/// May this option make the difference? The renderer itself is spoken of by the steps.
bool may_part(const StoryPair& c, const Option& option) {
  return option.effect == OptionEffect::picture && option.group != "Renderer" && explains(c, option.key);
}

}  // namespace

const Option* differing_option(const StoryPair& c, std::initializer_list<std::string_view> groups) {
  for (const Option& option : option_table())
    if (std::find(groups.begin(), groups.end(), option.group) != groups.end() && may_part(c, option)) return &option;
  return nullptr;
}

const Option* differing_in_what_is_seen(const StoryPair& c) {
  if (c.with_listing()) return nullptr;
  return differing_option(c, {"Camera", "Sampling", "Visibility", "Drawing"});
}

std::string all_differences(const StoryPair& c) {
  std::string text;
  for (const Option& option : option_table())
    if (may_part(c, option)) text += (text.empty() ? "" : ", ") + option_difference(c, option.key);
  return text;
}

}  // namespace ps::parting
