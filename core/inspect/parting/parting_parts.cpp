#include "inspect/parting/parting_parts.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "options/option.h"

namespace ps::parting {
namespace {

/// A listing and a kernel may do the same sums in another order.
constexpr double other_order = 1e-9;

/// Does the renderer of one side not act on the option, as drivers on sub-pixel bits? Then its values explain nothing.
bool is_lacked(const StorySide& side, std::string_view key) {
  const RendererKind& kind = renderer_kind(side.settings.renderer);
  return kind.lacks_option && kind.lacks_option(*find_option(key), side.settings).has_value();
}

}  // namespace

double Comparison::tolerance() const {
  if (a.story.renderer != b.story.renderer) return std::max(slack, 2e-3);
  for (const std::string_view key : {"precision", "self-hit", "shadow-epsilon", "reflection-epsilon", "epsilon-unit",
                                     "sphere-test", "triangle-test", "sample-position"})
    if (differs(*this, key)) return std::max(slack, 1e-4);
  return std::max(slack, with_listing() ? other_order : 0.0);
}

bool Comparison::same(double x, double y) const {
  if (x == y || (std::isnan(x) && std::isnan(y))) return true;
  return std::abs(x - y) <= tolerance() * std::max({1.0, std::abs(x), std::abs(y)});
}

bool Comparison::same(const Vec3d& x, const Vec3d& y) const {
  return same(x.x, y.x) && same(x.y, y.y) && same(x.z, y.z);
}

bool differs(const Comparison& c, std::string_view key) {
  const Option* option = find_option(key);
  PS_ASSERT(option, "causes name options by their keys");
  return option->get(c.a.settings) != option->get(c.b.settings);
}

std::string option_difference(const Comparison& c, std::string_view key) {
  const Option* option = find_option(key);
  PS_ASSERT(option, "causes name options by their keys");
  return fmt::format("{} is {} in A and {} in B", key, option_text(*option, c.a.settings),
                     option_text(*option, c.b.settings));
}

std::string because(const Comparison& c, std::initializer_list<std::string_view> keys) {
  for (const std::string_view key : keys)
    if (differs(c, key) && !is_lacked(c.a, key) && !is_lacked(c.b, key)) return ": " + option_difference(c, key);
  return {};
}

std::string because(const Comparison& c, const Option* option) {
  return option ? ": " + option_difference(c, option->key) : "";
}

bool acts_on(const Comparison& c, const StorySide& side, std::string_view key) {
  const Option* option = find_option(key);
  PS_ASSERT(option, "causes name options by their keys");
  const SceneTraits traits = scene_traits(c.scene);
  return !inactive_reason(*option, side.settings, traits) && !inactive_value_reason(*option, side.settings, traits);
}

namespace {

/// May this option make the difference? The renderer itself is spoken of by the steps.
bool may_part(const Comparison& c, const Option& option) {
  if (option.effect != OptionEffect::picture || option.group == "Renderer" || !differs(c, option.key)) return false;
  return acts_on(c, c.a, option.key) || acts_on(c, c.b, option.key);
}

}  // namespace

const Option* differing_option(const Comparison& c, std::initializer_list<std::string_view> groups) {
  for (const Option& option : option_table())
    if (std::find(groups.begin(), groups.end(), option.group) != groups.end() && may_part(c, option)) return &option;
  return nullptr;
}

const Option* differing_in_what_is_seen(const Comparison& c) {
  if (c.with_listing()) return nullptr;
  return differing_option(c, {"Camera", "Sampling", "Visibility", "Drawing"});
}

std::string all_differences(const Comparison& c) {
  std::string text;
  for (const Option& option : option_table())
    if (may_part(c, option)) text += (text.empty() ? "" : ", ") + option_difference(c, option.key);
  return text;
}

}  // namespace ps::parting
