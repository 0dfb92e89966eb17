#include "scene/model_files.h"

#include <algorithm>

#include "base/archived_file.h"

namespace ps {
namespace {

namespace fs = std::filesystem;

std::string small_letters(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

}  // namespace

const ModelFiles::Listing& ModelFiles::listing_of(const fs::path& folder) {
  const auto [place, is_new] = listings_.try_emplace(folder);
  if (!is_new) return place->second;
  for (const std::string& name : names_in_archived_folder(folder)) place->second.emplace(small_letters(name), name);
  std::error_code error;
  for (fs::directory_iterator entry(folder.empty() ? "." : folder, error), end; !error && entry != end;
       entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    const auto [known, is_first] = place->second.emplace(small_letters(name), name);
    if (!is_first) known->second = std::min(known->second, name);  // whatever the order of the listing
  }
  return place->second;
}

std::optional<fs::path> ModelFiles::find_in_any_case(const fs::path& folder, const fs::path& name) {
  if (name.is_absolute()) return {};
  fs::path path = folder;
  for (const fs::path& part : name) {
    std::error_code ignored;
    if (part == "." || part == ".." || fs::exists(path / part, ignored)) {
      path /= part;
      continue;
    }
    const Listing& listing = listing_of(path);
    const auto found = listing.find(small_letters(part.string()));
    if (found == listing.end()) return {};
    path /= found->second;
  }
  if (!is_any_file(path)) return {};
  return path;
}

std::optional<fs::path> ModelFiles::find(const std::vector<fs::path>& folders, std::string name) {
  if (name.size() > 2 && name.front() == '"' && name.back() == '"') name = name.substr(1, name.size() - 2);
  std::replace(name.begin(), name.end(), '\\', '/');
  const fs::path whole(name);
  for (const fs::path& folder : folders)
    for (const fs::path& path : {folder / whole, folder / whole.filename()})
      if (is_any_file(path)) return path;
  for (const fs::path& folder : folders)
    for (const fs::path& part : {whole, whole.filename()})
      if (auto path = find_in_any_case(folder, part)) return path;
  return {};
}

}  // namespace ps
