#include "options/difference_words.h"

#include <array>
#include <cctype>

#include <fmt/format.h>

#include "base/check.h"

namespace ps {
namespace {

/// "Shadow epsilon" inside a sentence; "CSG tree" and the like stay.
std::string within_sentence(std::string_view label) {
  std::string text(label);
  const bool abbreviation = text.size() > 1 && !std::islower(static_cast<unsigned char>(text[1]));
  if (!text.empty() && !abbreviation) text[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(text[0])));
  return text;
}

/// Words of options whose labels make no sense behind "with" and "without".
struct OwnWords {
  std::string_view key, with, without;
};
constexpr std::array own_words{
    OwnWords{"listing-bug", "with the bug", "without the bug"},
    OwnWords{"demo-slips", "with the demo's bugs", "without the demo's bugs"},
    OwnWords{"camera-relative", "relative to the camera", "in world coordinates"},
    OwnWords{"early-depth", "with an early depth pass", "without an early depth pass"},
    OwnWords{"renormalise", "normals renormalised", "normals as interpolated"},
    OwnWords{"diffuse", "with the diffuse term", "without the diffuse term"},
    OwnWords{"reflection-depth", "", "without reflections"},
    OwnWords{"environment", "", "without environment maps"},
    OwnWords{"volume-depth-clamp", "volumes clamped at the far limit", "volumes cut at the far limit"},
    OwnWords{"shadow-any-hit", "shadow rays stop at any hit", "shadow rays find the nearest hit"},
    OwnWords{"shadow-cache", "with a shadow cache", "without a shadow cache"},
    OwnWords{"cache-constants", "constants computed once per ray", "constants computed in each test"},
    OwnWords{"accelerator", "", "without an accelerator"}};

}  // namespace

bool is_without(const Option& option, const Settings& settings) {
  if (option.key == "reflection-depth" || option.kind == OptionKind::boolean) return option.get(settings) == 0;
  if (option.kind != OptionKind::choice) return false;
  const std::string_view key = chosen(option, settings).key;
  return key == "none" || key == "off";
}

std::string value_label(const Option& option, std::string_view value) {
  for (const Choice& choice : option.choices)
    if (choice.key == value) return std::string(choice.label);
  return std::string(value);
}

std::string setting_words(const Option& option, const Settings& settings) {
  const std::string label = within_sentence(option.label);
  const bool without = is_without(option, settings);
  if (without || option.kind == OptionKind::boolean || option.key == "listing-bug") {
    for (const OwnWords& own : own_words)
      if (own.key == option.key) return std::string(without ? own.without : own.with);
    return (without ? "without " : "with ") + label;
  }
  switch (option.kind) {
  case OptionKind::boolean:
    break;  // above
  case OptionKind::choice:
    if (option.key == "renderer") return std::string(chosen(option, settings).label);
    return fmt::format("{}: {}", label, chosen(option, settings).label);
  case OptionKind::integer:
  case OptionKind::real:
    return fmt::format("{} {}", label, option_text(option, settings));
  }
  return {};
}

std::string setting_words(std::string_view assignment) {
  const Option* option = find_option(assignment.substr(0, assignment.find('=')));
  if (!option || assignment.find('=') == std::string_view::npos) return std::string(assignment);
  Settings settings;
  try {
    parse_assignment(assignment, settings);
  } catch (const InputError&) {
    return std::string(assignment);
  }
  return setting_words(*option, settings);
}

namespace {

/// A part of a list in words, and what follows it after the end of a sentence as it is: "depth=64. All on SIMD code."
std::string part_in_words(std::string_view part) {
  auto end = part.find(". ");
  if (end == std::string_view::npos && part.ends_with('.')) end = part.size() - 1;
  if (end == std::string_view::npos) return setting_words(part);
  return setting_words(part.substr(0, end)) + std::string(part.substr(end));
}

}  // namespace

std::string settings_in_words(std::string_view text, std::string_view separator) {
  std::string words;
  while (true) {
    const auto end = text.find(separator);
    words += part_in_words(text.substr(0, end));
    if (end == std::string_view::npos) return words;
    words += separator;
    text.remove_prefix(end + separator.size());
  }
}

std::string difference_words(const Settings& of, const Settings& other) {
  std::string words;
  for (const Option& option : option_table())
    if (option.get(of) != option.get(other))
      words += fmt::format("{}{}", words.empty() ? "" : ", ", setting_words(option, of));
  return words;
}

}  // namespace ps
