#include "document/permalink_file.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/archived_file.h"
#include "base/atomic_file.h"
#include "base/check.h"
#include "base/extension.h"
#include "base/resources.h"
#include "document/bundle.h"
#include "document/permalink.h"
#include "image/file.h"

namespace ps {
namespace {

constexpr std::uintmax_t largest_permalink = 1u << 20;  // bytes

namespace fs = std::filesystem;

bool is_there(const fs::path& path) {
  std::error_code error;
  return fs::exists(path, error) || is_any_file(path);
}

/// The path that begins in this folder or in one above it; nullopt if there is none.
std::optional<fs::path> found_above(const fs::path& name, fs::path folder) {
  for (folder = fs::absolute(folder).lexically_normal();; folder = folder.parent_path()) {
    if (is_there(folder / name)) return (folder / name).lexically_normal();
    if (folder == folder.parent_path()) return {};
  }
}

/// The link with the paths that can be found; the working folder counts first.
std::string found_from(const fs::path& file, const std::string& link) {
  return with_paths(link, [&](const std::string& name) {
    if (fs::path(name).is_absolute() || is_there(name)) return name;
    const auto found = found_above(name, file.parent_path());
    return found ? found->string() : name;
  });
}

}  // namespace

std::string with_paths(std::string_view link, const std::function<std::string(const std::string&)>& change) {
  std::string result;
  for (std::size_t at = 0; at <= link.size();) {
    const std::size_t end = std::min(link.find('&', at), link.size());
    std::string part(link.substr(at, end - at));
    at = end + 1;
    const std::size_t value_at = part.find('=') + 1;
    const std::string key = part.substr(0, value_at);
    const bool texture = key.starts_with("edit.object.") && key.ends_with(".texture=");
    if (texture || key == "scene=" || key == "picture-b=" || key == "lesson=") {
      std::string value = percent_unescape(part.substr(value_at));
      const bool quoted = texture && value.size() > 2 && value.starts_with('"') && value.ends_with('"');
      if (quoted) value = value.substr(1, value.size() - 2);
      const bool is_path = value.find_first_of("/.") != std::string::npos && local_name(value) == value;
      if (is_path) value = change(value);
      part = key + percent_escape(quoted ? fmt::format("\"{}\"", value) : value);
    }
    result += (result.empty() ? "" : "&") + part;
  }
  return result;
}

std::optional<std::string> permalink_in_file(const std::filesystem::path& path) {
  if (path.extension() == permalink_extension) {
    const std::string text = read_whole_file(path, largest_permalink);
    const std::string line = text.substr(0, text.find_first_of("\r\n"));
    if (line.empty()) throw InputError({path.string(), 1, 1}, "an empty line", "a permalink");
    return found_from(path, line);
  }
  if (path.extension() == archive_extension) return permalink_in_bundle(path);
  if (lower_extension(path) != ".png") return {};
  for (const ImageText& text : load_texts(path))
    if (text.key == "permalink") return found_from(path, text.value);
  return {};
}

std::string permalink_for_file(const fs::path& path, const Document& document) {
  return with_paths(permalink(document), [&](const std::string& name) {
    const bool is_lost = fs::path(name).is_relative() && is_there(name) && !found_above(name, path.parent_path());
    return is_lost ? fs::absolute(name).lexically_normal().string() : name;
  });
}

void save_permalink(const std::filesystem::path& path, const Document& document) {
  write_file_atomically(path, permalink_for_file(path, document) + "\n");
}

}  // namespace ps
