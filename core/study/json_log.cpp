#include "study/json_log.h"

#include <algorithm>
#include <sstream>
#include <utility>

#include <fmt/format.h>

#include "base/atomic_file.h"
#include "base/check.h"

namespace ps {
namespace {

/// Levels of braces and brackets, without those in strings. Counted before the text becomes a tree: what walks over
/// a tree calls itself for each level.
int json_levels(std::string_view text) {
  int level = 0, deepest = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '"') in_string = !in_string;
    if (in_string) {
      if (c == '\\') ++i;
    } else if (c == '{' || c == '[') {
      deepest = std::max(deepest, ++level);
    } else if (c == '}' || c == ']') {
      --level;
    }
  }
  return deepest;
}

/// The beginning of a text, for a message.
std::string beginning(std::string_view text) {
  constexpr std::size_t most_shown = 40;
  std::string shown;
  for (const char c : text.substr(0, most_shown)) shown += c >= ' ' && c <= '~' ? c : '?';
  return text.size() > most_shown ? shown + "..." : shown;
}

std::string json_shown(const nlohmann::ordered_json& object, const char* key) {
  if (!object.contains(key)) return fmt::format("found no {}", key);
  const auto& value = object.at(key);
  return fmt::format("found {} = {}", key, value.is_structured() ? value.type_name() : beginning(value.dump()));
}

}  // namespace

JsonLog read_json_log(const std::filesystem::path& path) {
  JsonLog log;
  std::istringstream text(read_whole_file(path));
  int number = 0;
  for (std::string line; std::getline(text, line);) {
    ++number;
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    if (const int levels = json_levels(line); levels > deepest_json_line) {
      log.damaged.push_back(
          {number, line, fmt::format("found {} levels of brackets, expected at most {}", levels, deepest_json_line)});
      continue;
    }
    auto json = nlohmann::ordered_json::parse(line, nullptr, false);
    if (json.is_object())
      log.lines.push_back({number, line, std::move(json)});
    else
      log.damaged.push_back({number, line, fmt::format("found '{}', expected a JSON object", beginning(line))});
  }
  return log;
}

std::string damage_text(const std::filesystem::path& path, const DamagedLine& line) {
  return fmt::format("{}:{}: {}", path.string(), line.number, line.reason);
}

std::filesystem::path keep_aside(const std::filesystem::path& path, const std::vector<std::string>& lines,
                                 const std::string& ending) {
  auto aside = path;
  aside += ending;
  std::error_code error;
  std::string kept = std::filesystem::exists(aside, error) ? read_whole_file(aside) : "";
  for (const std::string& line : lines) kept += line + "\n";
  write_file_atomically(aside, kept);
  return aside;
}

FileLock lock_log_folder(const std::filesystem::path& folder, std::string_view doing) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (!std::filesystem::is_directory(folder)) throw InputError(folder.string() + ": cannot be made a folder");
  if (auto lock = FileLock::try_lock(folder / "runs.lock")) return std::move(*lock);
  throw InputError(fmt::format("{}: another program is {} there; wait until it ends, or choose another folder",
                               folder.string(), doing));
}

double json_number(const nlohmann::ordered_json& object, const char* key, double low, double high) {
  if (object.contains(key) && object.at(key).is_number())
    if (const double value = object.at(key); value >= low && value <= high) return value;
  throw InputError(fmt::format("{}, expected a number from {} to {}", json_shown(object, key), low, high));
}

int json_integer(const nlohmann::ordered_json& object, const char* key, int low, int high) {
  if (object.contains(key) && object.at(key).is_number_integer())
    if (const double value = object.at(key); value >= low && value <= high) return static_cast<int>(value);
  throw InputError(fmt::format("{}, expected a whole number from {} to {}", json_shown(object, key), low, high));
}

}  // namespace ps
