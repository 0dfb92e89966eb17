#include "cli/output_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "base/check.h"

namespace ps::cli {

std::string lower_extension(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

void require_output_file(const std::string& path, OutputKind kind) {
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  std::error_code error;
  if (!folder.empty() && !std::filesystem::is_directory(folder, error))
    throw InputError(fmt::format("{}: the folder '{}' does not exist", path, folder.string()));
  if (std::filesystem::is_directory(path, error)) throw InputError(fmt::format("{}: is a folder", path));
  if (kind == OutputKind::any) return;
  const std::string extension = lower_extension(path);
  if (extension != ".png" && extension != ".ppm" && extension != ".pfm")
    throw InputError(fmt::format("{}: found the extension '{}', expected .png, .ppm or .pfm", path, extension));
}

}  // namespace ps::cli
