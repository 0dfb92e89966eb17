#include "gui/panels/studies/study_folder.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "gui/platform/state_file.h"

namespace ps::gui {
namespace {

constexpr std::size_t most_kept = 24;

/// FNV-1a: names the folder; what is in it says itself what it belongs to.
std::uint64_t hash_of(const std::string& text) {
  std::uint64_t hash = 14695981039346656037ull;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ull;
  return hash;
}

}  // namespace

StudyFolder::StudyFolder(bool remember) {
  const auto state = remember ? StateFile::default_path() : std::filesystem::path();
  temporary_ = state.empty();
  std::error_code error;
  if (temporary_)
    root_ = std::filesystem::temp_directory_path(error) / fmt::format("pixelscope-studies-{}", getpid());
  else
    root_ = state.parent_path() / "studies";
  if (!temporary_) remove_oldest();
}

StudyFolder::~StudyFolder() {
  if (temporary_) forget(root_);
}

std::filesystem::path StudyFolder::of(const std::string& key) const {
  return root_ / fmt::format("{:016x}", hash_of(key));
}

bool StudyFolder::holds_results(const std::filesystem::path& folder) {
  std::error_code error;
  return std::filesystem::exists(folder / "runs.jsonl", error);
}

void StudyFolder::forget(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::remove_all(folder, error);
}

void StudyFolder::remove_oldest() const {
  std::vector<std::pair<std::filesystem::file_time_type, std::filesystem::path>> folders;
  std::error_code error;
  for (auto entry = std::filesystem::directory_iterator(root_, error);
       !error && entry != std::filesystem::directory_iterator(); entry.increment(error)) {
    std::error_code unknown;
    if (entry->path() == scenes()) continue;
    folders.emplace_back(entry->last_write_time(unknown), entry->path());
  }
  if (folders.size() <= most_kept) return;
  std::sort(folders.begin(), folders.end());
  folders.resize(folders.size() - most_kept);
  for (const auto& [time, path] : folders) forget(path);
}

}  // namespace ps::gui
