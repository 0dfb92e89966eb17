#include "options/scene_settings.h"

#include <string_view>

#include <fmt/format.h>

#include "base/check.h"
#include "base/spelling.h"
#include "options/option.h"

namespace ps {
namespace {

/// A scene that was not read from a file has its name alone.
SourcePlace place_in(const Scene& scene, const SourcePlace& place) {
  return place.line > 0 ? place : SourcePlace{"scene " + scene.name, 0, 0};
}

[[noreturn]] void fail_unknown(const SceneSetting& setting, const Scene& scene) {
  std::vector<std::string_view> known;
  for (const Option& option : option_table()) known.push_back(option.key);
  throw InputError(place_in(scene, setting.key_place),
                   fmt::format("unknown key '{}' in settings", setting.key.substr(0, 60)),
                   expected_word(setting.key, known));
}

}  // namespace

Settings settings_for(const Scene& scene) {
  Settings settings;
  for (const SceneSetting& setting : scene.settings) {
    const Option* option = find_option(setting.key);
    if (!option) fail_unknown(setting, scene);
    try {
      parse_option(*option, setting.value, settings);
    } catch (const InputError& error) {
      throw InputError(place_in(scene, setting.value_place), error.found(), error.expected());
    }
  }
  return settings;
}

std::vector<std::string> settings_difference(const Settings& from, const Settings& to) {
  std::vector<std::string> assignments;
  for (const Option& option : option_table())
    if (option.get(from) != option.get(to))
      assignments.push_back(std::string(option.key) + "=" + option_text(option, to));
  return assignments;
}

}  // namespace ps
