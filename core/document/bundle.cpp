#include "document/bundle.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "base/archived_file.h"
#include "base/atomic_file.h"
#include "base/check.h"
#include "base/tar.h"
#include "document/permalink.h"
#include "document/permalink_file.h"
#include "scene/load.h"

namespace ps {
namespace {

namespace fs = std::filesystem;

const std::string screen_name = std::string("screen") + permalink_extension;

fs::path whole_path(const std::string& name) { return fs::absolute(name).lexically_normal(); }

/// The folder that holds all of them.
fs::path common_folder(const std::vector<fs::path>& files) {
  fs::path folder = files.front().parent_path();
  for (const fs::path& file : files)
    while (std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first != folder.end())
      folder = folder.parent_path();
  return folder;
}

/// All files of the user's that the screen shows: those that its permalink names, and what the scene reads.
std::vector<fs::path> files_for(const Document& document, const std::string& link) {
  std::vector<fs::path> files;
  bool own_scene = false;
  with_paths(link, [&](const std::string& name) {
    if (!is_any_file(name)) return name;
    own_scene = own_scene || name == document.scene_name;
    files.push_back(whole_path(name));
    return name;
  });
  if (own_scene)
    for (const std::string& file : files_of(document.base))
      if (is_any_file(file)) files.push_back(whole_path(file));
  std::sort(files.begin(), files.end());
  files.erase(std::unique(files.begin(), files.end()), files.end());
  return files;
}

/// The only name with this ending; empty where there is none or several.
std::string only_name(const std::vector<std::string>& names, std::string_view ending) {
  std::string found;
  for (const std::string& name : names) {
    if (!name.ends_with(ending)) continue;
    if (!found.empty()) return {};
    found = name;
  }
  return found;
}

}  // namespace

void save_bundle(const fs::path& file, const Document& document) {
  Document shown = document;
  if (is_any_file(fs::path(shown.lesson) / "lesson.md")) {  // a lesson of the user's, whose page does not go along
    shown.lesson.clear();
    shown.step = 0;
  }
  const std::string link = permalink(shown);
  const std::vector<fs::path> files = files_for(shown, link);
  const fs::path root = files.empty() ? fs::path() : common_folder(files);
  const auto inside = [&](const fs::path& path) { return "files/" + path.lexically_relative(root).generic_string(); };
  std::vector<TarEntry> entries{{screen_name, with_paths(link, [&](const std::string& name) {
                                                const fs::path path = whole_path(name);
                                                return std::binary_search(files.begin(), files.end(), path)
                                                           ? inside(path)
                                                           : name;
                                              }) + "\n"}};
  for (const fs::path& path : files) entries.push_back({inside(path), read_whole_file(path, largest_archive)});
  const std::string archive = tar_bytes(entries);
  if (archive.size() > largest_archive)
    throw InputError(fmt::format("{}: the files of the scene have {} bytes, expected at most {} for a bundle",
                                 file.string(), archive.size(), largest_archive));
  write_file_atomically(file, archive);
}

std::string permalink_in_bundle(const fs::path& file) {
  const std::vector<std::string> names = names_in_archive(file);
  const auto in_archive = [&](const std::string& name) {
    const std::string inner = fs::path(name).lexically_normal().generic_string();
    return std::binary_search(names.begin(), names.end(), inner) ? (file / inner).string() : name;
  };
  if (const auto text = archived_file(file / screen_name))
    return with_paths(text->substr(0, text->find_first_of("\r\n")), in_archive);
  std::string scene = only_name(names, ".scene");
  if (scene.empty()) scene = only_name(names, ".obj");
  if (scene.empty())
    throw InputError(fmt::format("{}: found an archive of {} files, expected one with '{}', or with one scene or model",
                                 file.string(), names.size(), screen_name));
  return "scene=" + percent_escape(in_archive(scene));
}

}  // namespace ps
