#include "gui/app/autosave.h"

#include <unistd.h>

#include <algorithm>
#include <utility>

#include "base/atomic_file.h"
#include "base/check.h"

namespace ps::gui {
namespace {

constexpr const char* prefix = "open-";
constexpr const char* suffix = ".permalink";
constexpr std::uintmax_t largest = 1 << 20;

/// The process number in an autosave file's name, or nothing for another file.
std::optional<std::string> process_of(const std::filesystem::path& path) {
  const std::string name = path.filename().string();
  const std::size_t ends = std::string(prefix).size() + std::string(suffix).size();
  if (!name.starts_with(prefix) || !name.ends_with(suffix) || name.size() <= ends) return {};
  const std::string number = name.substr(std::string(prefix).size(), name.size() - ends);
  if (!std::all_of(number.begin(), number.end(), [](char c) { return c >= '0' && c <= '9'; })) return {};
  return number;
}

}  // namespace

Autosave::Autosave(std::filesystem::path folder) : folder_(std::move(folder)) {}

Autosave::~Autosave() {
  std::error_code ignored;
  if (!saved_.empty()) std::filesystem::remove(own_file(), ignored);
}

std::filesystem::path Autosave::own_file() const { return folder_ / (prefix + std::to_string(getpid()) + suffix); }

std::optional<std::string> Autosave::take_left_behind() {
  if (folder_.empty()) return {};
  std::error_code error;
  std::optional<std::string> found;
  for (const auto& entry : std::filesystem::directory_iterator(folder_, error)) {
    const auto process = process_of(entry.path());
    if (!process || std::filesystem::exists("/proc/" + *process)) continue;
    try {
      found = read_whole_file(entry.path(), largest);
    } catch (const InputError&) {
      continue;
    }
    std::error_code ignored;
    std::filesystem::remove(entry.path(), ignored);
  }
  return found;
}

void Autosave::save(const std::string& text) {
  if (folder_.empty() || text.empty() || text == saved_) return;
  std::error_code ignored;
  std::filesystem::create_directories(folder_, ignored);
  try {
    write_file_atomically(own_file(), text, Durability::quick);
    saved_ = text;
  } catch (const InputError&) {
    folder_.clear();  // a folder that cannot be written will not become writable with the next change
  }
}

}  // namespace ps::gui
