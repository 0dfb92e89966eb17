#pragma once
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/check.h"
#include "base/enumerators.h"
#include "options/option.h"

/// Helpers for writing rows of the option table. Each group has a file with one function that returns its rows;
/// table.cpp puts them in order.

namespace ps::rows {

template <auto Member>
OptionNumber get_member(const Settings& settings) {
  return static_cast<OptionNumber>(settings.*Member);
}

template <auto Member>
void set_member(Settings& settings, OptionNumber value) {
  using Value = std::remove_reference_t<decltype(settings.*Member)>;
  if constexpr (std::is_same_v<Value, bool>)
    settings.*Member = value != 0;
  else if constexpr (std::is_enum_v<Value>)
    settings.*Member = static_cast<Value>(static_cast<int>(value));
  else
    settings.*Member = static_cast<Value>(value);
}

constexpr Truth as_set() { return {TruthKind::as_set, {}}; }
constexpr Truth other_picture() { return {TruthKind::other_picture, {}}; }
constexpr Truth exactly(std::string_view settings) { return {TruthKind::exact, settings}; }
constexpr Truth pixel_average(std::string_view settings = {}) { return {TruthKind::pixel_average, settings}; }

/// The truth of options that only rays show exactly. One sample of theirs is no better than one of another renderer.
Truth averaged_by_rays();

/// The members that all kinds of rows share; see the members of Option.
struct Names {
  std::string_view key, label;
  OptionHelp help;
  std::string_view keywords{};
  Truth truth;
  ActsFor acts_for = ActsFor::rays | ActsFor::fragments;
  std::string_view only_for{};
  std::optional<IdleReason> (*inactive)(const Settings&, const SceneTraits&) = nullptr;
  OptionEffect effect = OptionEffect::picture;
};

template <auto Member>
Option row(const Names& names, OptionKind kind) {
  Option option;
  option.key = names.key;
  option.label = names.label;
  option.help = names.help;
  option.keywords = names.keywords;
  option.truth = names.truth;
  option.acts_for = names.acts_for;
  option.only_for = names.only_for;
  option.inactive = names.inactive;
  option.effect = names.effect;
  option.kind = kind;
  option.get = &get_member<Member>;
  option.set = &set_member<Member>;
  return option;
}

template <auto Member>
Option toggle(const Names& names) {
  return row<Member>(names, OptionKind::boolean);
}

/// The choices come in the order of the enum, one for each enumerator.
template <auto Member>
Option choice(const Names& names, std::vector<Choice> choices) {
  using Value = std::remove_cvref_t<decltype(std::declval<Settings>().*Member)>;
  if constexpr (std::is_enum_v<Value>)
    PS_ASSERT(choices.size() == enumerator_count<Value>(), "choices of " + std::string(names.key));
  Option option = row<Member>(names, OptionKind::choice);
  option.choices = std::move(choices);
  option.maximum = static_cast<double>(option.choices.size()) - 1;
  return option;
}

template <auto Member>
Option integer(const Names& names, int minimum, int maximum, std::string_view unit = {}) {
  Option option = row<Member>(names, OptionKind::integer);
  option.minimum = minimum;
  option.maximum = maximum;
  option.unit = unit;
  return option;
}

template <auto Member>
Option real(const Names& names, double minimum, double maximum, OptionScale scale, std::string_view unit = {}) {
  Option option = row<Member>(names, OptionKind::real);
  option.minimum = minimum;
  option.maximum = maximum;
  option.scale = scale;
  option.unit = unit;
  return option;
}

using Reason = std::optional<IdleReason>;

/// A value of `far` to offer where any limit will do; scene units.
inline constexpr double some_far_limit = 10000;

/// Fragments alone can be left out of a triangle. A reason used by several groups.
inline Reason needs_filled_fragments(const Settings& s) {
  if (draws_fragments(s.renderer) && s.draw != Draw::filled) return needs("draw", Draw::filled);
  return {};
}

std::vector<Option> renderer_rows();
std::vector<Option> camera_rows();
std::vector<Option> sampling_rows();
std::vector<Option> visibility_rows();
std::vector<Option> drawing_rows();
std::vector<Option> shading_rows();
std::vector<Option> texture_rows();
std::vector<Option> shadow_rows();
std::vector<Option> reflection_rows();
std::vector<Option> intersection_rows();
std::vector<Option> speed_rows();
std::vector<Option> display_rows();

}  // namespace ps::rows
