#include "gui/platform/state_file.h"

#include <algorithm>
#include <chrono>
#include <sstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/atomic_file.h"
#include "base/check.h"
#include "base/file_lock.h"
#include "base/number_text.h"
#include "base/spelling.h"
#include "base/user_folder.h"

namespace ps::gui {
namespace {

constexpr std::uintmax_t largest_state = 1 << 20;
constexpr const char* format_key = "format";
constexpr int this_format = 1;  ///< of the file; one without a number is of the same

/// The file is of an older or a newer program.
class OtherVersion : public InputError {
 public:
  using InputError::InputError;
};

/// Throws InputError for a text that is not a state file, OtherVersion for one of another program. Entries that are not
/// text are named in `odd`.
std::map<std::string, std::string> parse_state(const std::string& text, std::vector<std::string>& odd) {
  const auto json = nlohmann::json::parse(text, nullptr, false);
  if (json.is_discarded()) throw InputError("found no JSON, expected what the window writes there");
  if (!json.is_object()) throw InputError(fmt::format("found {}, expected an object", json.type_name()));
  if (const auto format = json.find(format_key); format != json.end() && *format != this_format)
    throw OtherVersion(fmt::format("found format {} of {} version, expected {}", shown_start(format->dump()),
                                   *format < this_format ? "an older" : "another", this_format));
  std::map<std::string, std::string> entries;
  for (const auto& [key, value] : json.items())
    if (value.is_string())
      entries[key] = value.get<std::string>();
    else if (key != format_key)
      odd.push_back(fmt::format("{}: found {}, expected text", shown_start(key), value.type_name()));
  return entries;
}

std::vector<std::string> split_lines(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);)
    if (!line.empty()) lines.push_back(line);
  return lines;
}

/// `ours` with what `theirs` has and neither `ours` nor `before` had, after the first entry.
std::string merged_lines(const std::string& ours, const std::string& theirs, const std::string& before) {
  std::vector<std::string> lines = split_lines(ours);
  const std::vector<std::string> known = split_lines(before);
  const auto lacks = [](const std::vector<std::string>& all, const std::string& line) {
    return std::find(all.begin(), all.end(), line) == all.end();
  };
  std::size_t place = std::min<std::size_t>(lines.size(), 1);
  for (const std::string& line : split_lines(theirs))
    if (lacks(lines, line) && lacks(known, line))
      lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(place++), line);
  std::string text;
  for (const std::string& line : lines) text += line + '\n';
  return text;
}

}  // namespace

std::filesystem::path StateFile::default_path() {
  const auto folder = user_folder("XDG_STATE_HOME", ".local/state");
  return folder.empty() ? folder : folder / "pixelscope" / "window.json";
}

std::filesystem::path config_file(const std::string& name) {
  const auto folder = user_folder("XDG_CONFIG_HOME", ".config");
  return folder.empty() ? folder : folder / "pixelscope" / name;
}

StateFile::StateFile(std::filesystem::path path) : path_(std::move(path)) {
  std::error_code error;
  if (path_.empty() || !std::filesystem::exists(path_, error)) return;
  if (!std::filesystem::is_regular_file(path_, error)) {
    complaints_.push_back(path_.string() + ": is not a regular file; the window remembers nothing");
    path_.clear();
    return;
  }
  try {
    std::vector<std::string> odd;
    entries_ = read_ = parse_state(read_whole_file(path_, largest_state), odd);
    if (!odd.empty())
      complaints_.push_back(fmt::format("{}: {}{}; ignored", path_.string(), odd.front(),
                                        odd.size() == 1 ? "" : fmt::format(" and {} more such", odd.size() - 1)));
  } catch (const OtherVersion& problem) {
    keep_aside(problem.what(), ".old");
  } catch (const InputError& problem) {
    keep_aside(problem.what(), ".damaged");
  }
}

/// Moves the file aside, so that saving does not replace it.
void StateFile::keep_aside(const std::string& why, const char* ending) {
  const std::string text = why.starts_with(path_.string()) ? why : fmt::format("{}: {}", path_.string(), why);
  auto aside = path_;
  aside += ending;
  std::error_code error;
  std::filesystem::rename(path_, aside, error);
  if (error) {
    complaints_.push_back(text + "; the window remembers nothing");
    path_.clear();
    return;
  }
  complaints_.push_back(fmt::format("{}; ignored, and kept as {}", text, aside.filename().string()));
}

std::string StateFile::get(const std::string& key) const {
  const auto found = entries_.find(key);
  return found == entries_.end() ? std::string() : found->second;
}

double StateFile::number(const std::string& key, double low, double high) {
  const std::string text = get(key);
  if (text.empty()) return 0;
  if (const auto value = parse_number(text); value && *value >= low && *value <= high) return *value;
  complain(key, fmt::format("a number from {} to {}", low, high));
  return 0;
}

void StateFile::complain(const std::string& key, const std::string& expected) {
  complaints_.push_back(
      fmt::format("{}: {}: found '{}', expected {}; ignored", path_.string(), key, shown_start(get(key)), expected));
}

void StateFile::set(const std::string& key, std::string value) {
  std::string& entry = entries_[key];
  if (entry == value) return;
  entry = std::move(value);
  changed_[key] = Kind::value;
}

void StateFile::set_lines(const std::string& key, std::string lines) {
  std::string& entry = entries_[key];
  if (entry == lines) return;
  entry = std::move(lines);
  changed_[key] = Kind::lines;
}

void StateFile::save() {
  if (changed_.empty() || path_.empty()) return;
  std::error_code error;
  std::filesystem::create_directories(path_.parent_path(), error);
  constexpr std::chrono::seconds patience{5};  // saving takes milliseconds, or the time that a slow disk needs
  try {
    // Whoever holds it longer than that hangs, and will not write; the own entries are not given up for it.
    const auto lock = FileLock::lock_within(FileLock::beside(path_), patience);
    take_over();
  } catch (const InputError&) {
    // A folder that cannot be written, or a file that another program has damaged since: both stay as they are.
  }
}

void StateFile::take_over() {
  Entries now;
  std::vector<std::string> odd;
  std::error_code error;
  if (std::filesystem::exists(path_, error)) now = parse_state(read_whole_file(path_, largest_state), odd);
  for (const auto& [key, kind] : changed_)
    now[key] = kind == Kind::lines ? merged_lines(entries_[key], now[key], read_[key]) : entries_[key];
  nlohmann::json json(now);
  json[format_key] = this_format;
  write_file_atomically(path_, json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
  entries_ = read_ = std::move(now);
  changed_.clear();
}

}  // namespace ps::gui
