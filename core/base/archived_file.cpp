#include "base/archived_file.h"

#include <algorithm>
#include <map>
#include <memory>
#include <mutex>
#include <set>

#include "base/check.h"
#include "base/read_file.h"
#include "base/tar.h"

namespace ps {
namespace {

namespace fs = std::filesystem;
using ArchivedFiles = std::map<std::string, std::string>;  // contents by name

/// A path divided where it leads into an archive.
struct ArchivedPlace {
  fs::path archive;
  std::string name;  ///< of a file or folder in it
};

std::optional<ArchivedPlace> place_in_archive(const fs::path& path) {
  if (path.generic_string().find(std::string(archive_extension) + "/") == std::string::npos) return {};
  fs::path before;
  for (auto part = path.begin(); part != path.end(); ++part) {
    before /= *part;
    std::error_code error;
    if (before.extension() != archive_extension || !fs::is_regular_file(before, error)) continue;
    fs::path name;
    for (auto rest = std::next(part); rest != path.end(); ++rest) name /= *rest;
    return ArchivedPlace{before, name.lexically_normal().generic_string()};
  }
  return {};
}

/// A scene reads its files one after another, so the archive that was read last is kept until it changes.
std::shared_ptr<const ArchivedFiles> files_of_archive(const fs::path& archive) {
  struct Kept {
    fs::path path;
    fs::file_time_type time;
    std::uintmax_t size = 0;
    std::shared_ptr<const ArchivedFiles> files;
  };
  static std::mutex mutex;
  static Kept kept;
  const std::lock_guard lock(mutex);
  std::error_code error;
  const auto time = fs::last_write_time(archive, error);
  const auto size = fs::file_size(archive, error);
  if (kept.files && kept.path == archive && kept.time == time && kept.size == size) return kept.files;
  auto files = std::make_shared<ArchivedFiles>();
  for (TarEntry& entry : read_tar(read_whole_file(archive, largest_archive), archive.string()))
    (*files)[std::move(entry.name)] = std::move(entry.bytes);
  kept = {archive, time, size, files};
  return files;
}

}  // namespace

std::optional<std::string> archived_file(const fs::path& path) {
  const auto place = place_in_archive(path);
  if (!place) return {};
  const auto files = files_of_archive(place->archive);
  const auto found = files->find(place->name);
  if (found == files->end()) return {};
  return found->second;
}

std::vector<std::string> names_in_archive(const fs::path& archive) {
  std::vector<std::string> names;
  for (const auto& [name, bytes] : *files_of_archive(archive)) names.push_back(name);
  return names;
}

std::vector<std::string> names_in_archived_folder(const fs::path& folder) {
  const auto place = place_in_archive(folder / ".");
  if (!place) return {};
  const std::string start = place->name == "." ? "" : place->name;  // ends with a /
  std::set<std::string> names;
  for (const std::string& name : names_in_archive(place->archive))
    if (name.starts_with(start)) names.insert(name.substr(start.size(), name.find('/', start.size()) - start.size()));
  return {names.begin(), names.end()};
}

fs::path file_on_disk(const fs::path& path) {
  const auto place = place_in_archive(path);
  return place ? place->archive : path;
}

bool is_any_file(const fs::path& path) {
  std::error_code error;
  if (fs::is_regular_file(path, error)) return true;
  try {
    return archived_file(path).has_value();
  } catch (const InputError&) {
    return false;
  }
}

}  // namespace ps
