#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "base/enumerators.h"
#include "cli/command.h"
#include "options/option.h"
#include "study/reference.h"

namespace ps::cli {
namespace {

using Json = nlohmann::ordered_json;

bool has_range(const Option& option) { return option.kind == OptionKind::integer || option.kind == OptionKind::real; }

Json option_json(const Option& option) {
  Json json{{"key", option.key},
            {"label", option.label},
            {"group", option.group},
            {"kind", enumerator_key(option.kind)},
            {"default", option_text(option, Settings{})},
            {"effect", enumerator_key(option.effect)},
            {"help", {{"what", option.help.what}, {"source", option.help.source}, {"fails", option.help.fails}}},
            {"truth", truth_text(option)}};
  for (const Choice& choice : option.choices)
    json["choices"].push_back({{"key", choice.key}, {"label", choice.label}, {"help", choice.help}});
  if (has_range(option)) {
    json["minimum"] = option.minimum;
    json["maximum"] = option.maximum;
    json["scale"] = option.scale == OptionScale::linear ? "linear" : "logarithmic";
    json["unit"] = option.unit;
  }
  return json;
}

/// The values with the default in brackets: "[offset] epsilon normal-bump", "[0.001] 0..10".
std::string values_text(const Option& option) {
  const std::string standard = option_text(option, Settings{});
  const std::string unit = option.unit.empty() ? "" : fmt::format(" {}", option.unit);
  if (has_range(option)) return fmt::format("[{}] {}..{}{}", standard, option.minimum, option.maximum, unit);
  if (option.kind == OptionKind::boolean) return standard == "on" ? "[on] off" : "on [off]";
  std::string text;
  for (const Choice& choice : option.choices)
    text += (text.empty() ? "" : " ") +
            (choice.key == standard ? fmt::format("[{}]", choice.key) : std::string(choice.key));
  return text;
}

void print_table() {
  std::string_view group;
  for (const Option& option : option_table()) {
    if (option.group != group) fmt::print("{}{}\n", group.empty() ? "" : "\n", option.group);
    group = option.group;
    fmt::print("  {:<20} {}\n", option.key, values_text(option));
    fmt::print("  {:<20} {}\n", "", option.help.what);
  }
}

void print_json() {
  Json all = Json::array();
  for (const Option& option : option_table()) all.push_back(option_json(option));
  fmt::print("{}\n", all.dump(2));
}

}  // namespace

void add_options_command(CLI::App& app, Action& chosen) {
  CLI::App* command = app.add_subcommand("options", "list all options, with defaults in brackets");
  const auto as_json = std::make_shared<bool>(false);
  command->add_flag("--json", *as_json, "as JSON, with all help texts");
  command->callback([&chosen, as_json] {
    chosen = [as_json] {
      if (*as_json)
        print_json();
      else
        print_table();
      return 0;
    };
  });
}

}  // namespace ps::cli
