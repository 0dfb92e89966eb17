#include "options/scene_settings.h"

#include <fmt/format.h>

#include "base/check.h"
#include "options/option.h"

namespace ps {

Settings settings_for(const Scene& scene) {
  Settings settings;
  for (const auto& [key, value] : scene.settings) {
    try {
      parse_assignment(fmt::format("{}={}", key, value), settings);
    } catch (const InputError& error) {
      throw InputError("scene " + scene.name + ": " + error.what());
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
