#pragma once
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "options/elsewhere.h"
#include "options/idle_reason.h"
#include "options/renderer_kind.h"
#include "options/settings.h"
#include "scene/scene.h"

namespace ps {

/// One value of an enumerated option.
struct Choice {
  std::string_view key;    ///< for files and the command line: "depth-buffer"
  std::string_view label;  ///< for people: "depth buffer"
  std::string_view help;   ///< one sentence
  /// Why another value is used instead with these settings and this scene, or nothing. May be nullptr: never.
  std::optional<IdleReason> (*inactive)(const Settings&, const SceneTraits&) = nullptr;
};

/// Three short texts that make the tooltip.
struct OptionHelp {
  std::string_view what;    ///< what it does
  std::string_view source;  ///< "CGFS ch. 4"
  std::string_view fails;   ///< how it fails, or what it costs
};

enum class OptionKind { boolean, integer, real, choice };
enum class OptionScale { linear, logarithmic };
/// What a change can touch: lets a front end keep a picture when only its display changes.
enum class OptionEffect { picture, display, speed };

/// What the error of a value is measured against, when pictures over several values are charted.
enum class TruthKind {
  undeclared,
  as_set,         ///< all values show the same, or what they show has no better value: the picture as set
  other_picture,  ///< each value shows another picture on purpose, and none of them is an error
  exact,          ///< the picture with the exact settings, sampled where the others are sampled
  pixel_average,  ///< the values estimate the mean colour over a pixel: that mean, of many samples
};
struct Truth {
  TruthKind kind = TruthKind::undeclared;
  /// The settings of the true picture: "K=V;K=V". "K=V1|V2" takes the first choice that can act.
  std::string_view exact{};
};

/// The parts of a row that all kinds of options share.
struct OptionFacts {
  std::string_view key;    ///< unique, in kebab-case
  std::string_view label;  ///< unique within its group
  OptionHelp help;
  /// Other words that people search for, separated by commas: "z-buffer, depth test".
  std::string_view keywords{};
  Truth truth;
  /// For which renderers it acts. A listing says itself which options it reads (options/listing.h).
  ActsFor acts_for = ActsFor::rays | ActsFor::fragments;
  /// Said of it under other renderers; empty: the words that follow from `acts_for`.
  std::string_view only_for{};
  /// Why the option cannot act with these settings and this scene ("needs a texture"), or nothing if it can. Asked only
  /// for renderers that `acts_for` names. May be nullptr: it always can.
  std::optional<IdleReason> (*inactive)(const Settings&, const SceneTraits&) = nullptr;
  OptionEffect effect = OptionEffect::picture;
  KnownTo known_to;  ///< a row without it does not compile
  ShownBy shown_by;  ///< nor without this
};

/// One row of the option table: everything that panels, command line, scene files, sweeps, permalinks, the help sheet,
/// renderers, studies and tests need to know about one member of Settings.
struct Option : OptionFacts {
  std::string_view group{};
  OptionKind kind = OptionKind::boolean;
  std::vector<Choice> choices{};            ///< kind choice only, in the order of the enum
  double minimum = 0, maximum = 0;          ///< integer and real only, both inclusive
  OptionScale scale = OptionScale::linear;  ///< how a slider or a sweep should step
  std::string_view unit{};                  ///< "px", "samples", ...; may be empty
  std::string_view sweep_values{};          ///< of a sweep that names none, "1,4,16"; empty: spread over the range
  OptionNumber (*get)(const Settings&) = nullptr;
  void (*set)(Settings&, OptionNumber) = nullptr;  ///< takes only values that are valid for the row
  const void* member = nullptr;                    ///< the row's member of Settings: member_id (options/choice_key.h)

  OptionNumber default_value() const { return get(Settings{}); }
};

/// All options, grouped, in the order in which panels show them.
std::span<const Option> option_table();
/// The row with this key, or nullptr.
const Option* find_option(std::string_view key);

/// The choice that the settings name; the option must be one of choices.
const Choice& chosen(const Option& option, const Settings& settings);

/// The value as text that parse_option reads back exactly: "on", "3", "0.001", "depth-buffer".
std::string option_text(const Option& option, const Settings& settings);
/// Sets the option from text. Throws InputError naming the key, what was found and what is allowed.
void parse_option(const Option& option, std::string_view text, Settings& settings);
/// Sets "key=value". Throws InputError for an unknown key, naming the nearest known one.
void parse_assignment(std::string_view assignment, Settings& settings);
/// Sets "key=value;key=value", from left to right; none if the text is empty. Throws InputError as above.
void parse_assignments(std::string_view assignments, Settings& settings);
/// Only the options that differ from the defaults, as "key=value" in table order.
std::vector<std::string> changed_options(const Settings& settings);
/// Why the option cannot act now, or nothing: the renderer does not use it, or its own reason.
std::optional<IdleReason> inactive_reason(const Option& option, const Settings& settings, const SceneTraits& traits);
/// Why this choice of an option, which can act, would not act now, or nothing. `choice` is one of option.choices.
std::optional<IdleReason> inactive_choice_reason(const Option& option, const Choice& choice, const Settings& settings,
                                                 const SceneTraits& traits);
/// The same for the value that `settings` hold, also where it is not a choice.
std::optional<IdleReason> inactive_value_reason(const Option& option, const Settings& settings,
                                                const SceneTraits& traits);

}  // namespace ps
