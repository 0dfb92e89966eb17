#pragma once
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/check.h"
#include "base/enumerators.h"
#include "options/choice_key.h"

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

template <auto Member>
Option row(const OptionFacts& facts, OptionKind kind) {
  Option option{facts};
  option.kind = kind;
  option.get = &get_member<Member>;
  option.set = &set_member<Member>;
  option.member = &member_id<Member>;
  return option;
}

template <auto Member>
Option toggle(const OptionFacts& facts) {
  return row<Member>(facts, OptionKind::boolean);
}

/// The choices come in the order of the enum, one for each enumerator.
template <auto Member>
Option choice(const OptionFacts& facts, std::vector<Choice> choices) {
  using Value = std::remove_cvref_t<decltype(std::declval<Settings>().*Member)>;
  if constexpr (std::is_enum_v<Value>)
    PS_ASSERT(choices.size() == enumerator_count<Value>(), "choices of " + std::string(facts.key));
  Option option = row<Member>(facts, OptionKind::choice);
  option.choices = std::move(choices);
  option.maximum = static_cast<double>(option.choices.size()) - 1;
  return option;
}

template <auto Member>
Option integer(const OptionFacts& facts, int minimum, int maximum, std::string_view unit = {}) {
  Option option = row<Member>(facts, OptionKind::integer);
  option.minimum = minimum;
  option.maximum = maximum;
  option.unit = unit;
  return option;
}

template <auto Member>
Option real(const OptionFacts& facts, double minimum, double maximum, OptionScale scale, std::string_view unit = {}) {
  Option option = row<Member>(facts, OptionKind::real);
  option.minimum = minimum;
  option.maximum = maximum;
  option.scale = scale;
  option.unit = unit;
  return option;
}

using Reason = std::optional<IdleReason>;

// Shorthands for OptionFacts::known_to and shown_by.
using enum FastCode;
inline constexpr AnyValue any_value;
inline constexpr NotAsked not_asked;
inline constexpr NoExperiment none;

/// The code knows these values alone.
template <class... Values>
FastLimit knows(FastCode code, int place, Values... values) {
  return {.code = code, .place = place, .known = {static_cast<OptionNumber>(values)...}};
}
inline FastLimit limit(FastCode code, int place, std::string_view reason,
                       bool (*reached)(const Settings&, const SceneTraits&)) {
  return {.code = code, .place = place, .reached = reached, .reason = std::string(reason)};
}

/// Does the member have this value? For experiments.
template <auto Member, auto Value>
bool is(const Settings& settings) {
  return settings.*Member == Value;
}
template <auto Member, auto Value>
bool is_not(const Settings& settings) {
  return settings.*Member != Value;
}

inline HardwareUse defined_as(std::string_view name) {
  HardwareUse use = any_value;
  use.definition = name;
  return use;
}
inline HardwareUse lacking(std::string_view reason, OptionNumber first, OptionNumber last) {
  HardwareUse use = any_value;
  use.reason = reason;
  use.first_lacked = first;
  use.last_lacked = last;
  return use;
}
template <class Value>
HardwareUse lacking(std::string_view reason, Value value) {
  return lacking(reason, static_cast<OptionNumber>(value), static_cast<OptionNumber>(value));
}
/// It does not act on the option at all.
inline HardwareUse lacking(std::string_view reason) {
  const OptionNumber all = std::numeric_limits<OptionNumber>::infinity();
  return lacking(reason, -all, all);
}
inline HardwareUse as_driver_offers(std::string_view reason) {
  HardwareUse use = any_value;
  use.reason = reason;
  use.as_driver_offers = true;
  return use;
}
inline HardwareUse lacking_if(Reason (*lacks)(OptionNumber, const Settings&)) {
  HardwareUse use = any_value;
  use.lacks = lacks;
  return use;
}

/// A value of `far` to offer where any limit will do; scene units.
inline constexpr double some_far_limit = 10000;

/// Fragments alone can be left out of a triangle. A reason used by several groups.
inline Reason needs_filled_fragments(const Settings& s) {
  if (draws_fragments(s.renderer) && !fills(s.draw)) return needs("draw", Draw::filled);
  return {};
}

/// Shadows come from shadow rays unless there are none, or maps give them. A reason used by several groups.
inline Reason needs_traced_shadows(const Settings& s) {
  const bool mapped = sends_rays(s.renderer) && s.shadows == Shadows::map;
  if (s.shadows == Shadows::none || mapped) return needs("shadows", Shadows::traced);
  return {};
}

/// Gives words to the limits for which the row has none. For the table.
void say_fast_limits(Option& option);

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
