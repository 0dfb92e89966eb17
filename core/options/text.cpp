#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/check.h"
#include "base/number_text.h"
#include "base/spelling.h"
#include "options/choice_key.h"
#include "options/renderer_kind.h"

namespace ps {
namespace {

std::string allowed_values(const Option& option) {
  switch (option.kind) {
  case OptionKind::boolean:
    return "on or off";
  case OptionKind::integer:
    return fmt::format("a whole number from {} to {}", option.minimum, option.maximum);
  case OptionKind::real:
    return fmt::format("a number from {} to {}", option.minimum, option.maximum);
  case OptionKind::choice: {
    std::string text = "one of";
    for (const Choice& choice : option.choices) text += fmt::format(" {}", choice.key);
    return text;
  }
  }
  return {};
}

/// The reason of an option that acts for other renderers than the chosen one.
std::string_view only_for(ActsFor set) {
  if (acts_for(set, PictureWay::rays)) return "only the ray tracer uses it";
  if (acts_for(set, PictureWay::fragments)) return "only the rasterizer uses it";
  return "only textbook listings use it";
}

[[noreturn]] void reject(const Option& option, std::string_view text) {
  throw InputError({fmt::format("option {}", option.key), 0, 0}, fmt::format("'{}'", shown_start(text)),
                   allowed_values(option));
}

}  // namespace

const Option* find_option(std::string_view key) {
  const auto table = option_table();
  const auto found = std::find_if(table.begin(), table.end(), [&](const Option& o) { return o.key == key; });
  return found == table.end() ? nullptr : &*found;
}

const Option& option_with(const void* member) {
  const auto table = option_table();
  const auto found = std::find_if(table.begin(), table.end(), [&](const Option& o) { return o.member == member; });
  PS_ASSERT(found != table.end(), "each member of Settings has a row");
  return *found;
}

const Choice& chosen(const Option& option, const Settings& settings) {
  return option.choices.at(static_cast<std::size_t>(option.get(settings)));
}

std::string option_text(const Option& option, const Settings& settings) {
  const OptionNumber value = option.get(settings);
  switch (option.kind) {
  case OptionKind::boolean:
    return value != 0 ? "on" : "off";
  case OptionKind::integer:
    return fmt::format("{}", static_cast<long long>(value));
  case OptionKind::real:
    return fmt::format("{}", value);
  case OptionKind::choice:
    return std::string(chosen(option, settings).key);
  }
  return {};
}

void parse_option(const Option& option, std::string_view text, Settings& settings) {
  if (option.kind == OptionKind::boolean) {
    if (text == "on" || text == "true" || text == "1") return option.set(settings, 1);
    if (text == "off" || text == "false" || text == "0") return option.set(settings, 0);
    reject(option, text);
  }
  if (option.kind == OptionKind::choice) {
    for (std::size_t i = 0; i < option.choices.size(); ++i)
      if (option.choices[i].key == text) return option.set(settings, static_cast<double>(i));
    reject(option, text);
  }
  const auto value = parse_number(text);
  if (!value || *value < option.minimum || *value > option.maximum) reject(option, text);
  if (option.kind == OptionKind::integer && std::floor(*value) != *value) reject(option, text);
  option.set(settings, *value);
}

void parse_assignment(std::string_view assignment, Settings& settings) {
  const auto equals = assignment.find('=');
  if (equals == std::string_view::npos)
    throw InputError(fmt::format("found '{}', expected KEY=VALUE", shown_start(assignment)));
  const std::string_view key = assignment.substr(0, equals);
  if (const Option* option = find_option(key)) return parse_option(*option, assignment.substr(equals + 1), settings);
  std::vector<std::string_view> known;
  for (const Option& option : option_table()) known.push_back(option.key);
  throw InputError(fmt::format("unknown option '{}'{}", shown_start(key),
                               did_you_mean(key, known, "; 'pixelscope-cli options' lists all options")));
}

void parse_assignments(std::string_view assignments, Settings& settings) {
  while (!assignments.empty()) {
    const std::size_t end = std::min(assignments.find(';'), assignments.size());
    parse_assignment(assignments.substr(0, end), settings);
    assignments.remove_prefix(std::min(end + 1, assignments.size()));
  }
}

std::vector<std::string> changed_options(const Settings& settings) {
  std::vector<std::string> changed;
  for (const Option& option : option_table())
    if (option.get(settings) != option.default_value())
      changed.push_back(fmt::format("{}={}", option.key, option_text(option, settings)));
  return changed;
}

std::optional<IdleReason> inactive_reason(const Option& option, const Settings& settings, const SceneTraits& traits) {
  using enum IdleReason::Kind;
  const RendererKind& kind = renderer_kind(settings.renderer);
  if (kind.lacks_option && acts_for(option.acts_for, kind.way))
    if (const auto reason = kind.lacks_option(option, settings)) return reason;
  if (kind.reads)
    if (const auto reads = kind.reads(option, settings, traits)) {
      if (!*reads) return IdleReason(renderer, kind.unread);
      if (!acts_for(option.acts_for, kind.way)) return {};
    }
  if (!acts_for(option.acts_for, kind.way))
    return IdleReason(renderer, option.only_for.empty() ? only_for(option.acts_for) : option.only_for);
  return option.inactive ? option.inactive(settings, traits) : std::nullopt;
}

std::optional<IdleReason> inactive_choice_reason(const Option& option, const Choice& choice, const Settings& settings,
                                                 const SceneTraits& traits) {
  if (choice.inactive)
    if (const auto reason = choice.inactive(settings, traits)) return reason;
  const RendererKind& kind = renderer_kind(settings.renderer);
  return kind.lacks_value ? kind.lacks_value(option, static_cast<double>(&choice - option.choices.data()), settings)
                          : std::nullopt;
}

std::optional<IdleReason> inactive_value_reason(const Option& option, const Settings& settings,
                                                const SceneTraits& traits) {
  if (option.kind == OptionKind::choice)
    return inactive_choice_reason(option, chosen(option, settings), settings, traits);
  const RendererKind& kind = renderer_kind(settings.renderer);
  return kind.lacks_value ? kind.lacks_value(option, option.get(settings), settings) : std::nullopt;
}

}  // namespace ps
