#include "gui/platform/state_file.h"

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>

namespace ps::gui {
namespace {

/// The folder named by a variable, or a folder below the home folder; empty if neither is known.
std::filesystem::path user_folder(const char* variable, const char* below_home) {
  if (const char* folder = std::getenv(variable); folder && *folder == '/') return folder;
  if (const char* home = std::getenv("HOME"); home && *home == '/') return std::filesystem::path(home) / below_home;
  return {};
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
  if (path_.empty()) return;
  std::ifstream file(path_);
  const auto json = nlohmann::json::parse(file, nullptr, false);
  if (!json.is_object()) return;
  for (const auto& [key, value] : json.items())
    if (value.is_string()) entries_[key] = value.get<std::string>();
}

std::string StateFile::get(const std::string& key) const {
  const auto found = entries_.find(key);
  return found == entries_.end() ? std::string() : found->second;
}

void StateFile::set(const std::string& key, std::string value) {
  std::string& entry = entries_[key];
  if (entry == value) return;
  entry = std::move(value);
  changed_ = true;
}

void StateFile::save() {
  if (!changed_ || path_.empty()) return;
  std::error_code error;
  std::filesystem::create_directories(path_.parent_path(), error);
  auto temporary = path_;
  temporary += ".new";
  {
    std::ofstream file(temporary);
    file << nlohmann::json(entries_).dump(1, ' ', false, nlohmann::json::error_handler_t::replace) << '\n';
    if (!file.flush()) return;
  }
  std::filesystem::rename(temporary, path_, error);
  changed_ = static_cast<bool>(error);
}

}  // namespace ps::gui
