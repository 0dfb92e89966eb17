#include "support/hostile_scene.h"

#include <array>
#include <filesystem>
#include <regex>
#include <vector>

#include "base/atomic_file.h"
#include "base/check.h"
#include "scene/scene_file.h"
#include "support/random_settings.h"

namespace ps::test {
namespace {

struct Source {
  std::string text, folder;
};

/// Scenes whose cost does not lie in their models, which would take seconds each.
const std::vector<Source>& sources() {
  static const std::vector<Source> all = [] {
    std::vector<Source> found;
    for (const auto& entry : std::filesystem::recursive_directory_iterator("assets/scenes")) {
      if (entry.path().extension() != ".scene") continue;
      Source source{read_whole_file(entry.path()), entry.path().parent_path().string()};
      if (source.text.find("generator") == std::string::npos && source.text.find("file") == std::string::npos &&
          source.text.find("include") == std::string::npos)
        found.push_back(std::move(source));
    }
    std::sort(found.begin(), found.end(), [](const Source& a, const Source& b) { return a.text < b.text; });
    return found;
  }();
  return all;
}

}  // namespace

std::optional<HostileScene> hostile_scene(std::mt19937& random) {
  static constexpr std::array<const char*, 14> extremes{"0",    "-0", "5e-324", "-5e-324", "1e-300", "1e-162", "1e-20",
                                                        "1e-8", "-1", "1",      "1e5",     "1e12",   "-1e12",  "1e30"};
  const Source& source = sources()[static_cast<std::size_t>(below(random, static_cast<int>(sources().size())))];
  std::string text = source.text;
  static const std::regex number(R"((^|[\s=(,])(-?[0-9]+\.?[0-9]*)(?=[\s,)]|$))");
  for (int changes = 1 + below(random, 4); changes > 0; --changes) {
    const std::vector<std::smatch> places(std::sregex_iterator(text.begin(), text.end(), number), {});
    if (places.empty()) break;
    const std::smatch& place = places[static_cast<std::size_t>(below(random, static_cast<int>(places.size())))];
    const auto at = static_cast<std::size_t>(place.position(2)), length = static_cast<std::size_t>(place.length(2));
    text = text.substr(0, at) + extremes[static_cast<std::size_t>(below(random, static_cast<int>(extremes.size())))] +
           text.substr(at + length);
  }
  try {
    return HostileScene{parse_scene(text, "hostile.scene", source.folder), text};
  } catch (const InputError&) {
    return {};
  }
}

}  // namespace ps::test
