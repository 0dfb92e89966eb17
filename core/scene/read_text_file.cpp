#include <fstream>

#include <fmt/format.h>

#include "scene/scene_file.h"

namespace ps {

std::string read_text_file(const std::filesystem::path& path, std::uintmax_t max_bytes) {
  const std::string name = path.string();
  const auto refuse = [&](const std::string& found, const std::string& expected) {
    throw InputError({name, 0, 0}, found, expected);
  };
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) refuse("no such file", "a file");
  if (std::filesystem::is_directory(status)) refuse("a folder", "a file");
  if (!std::filesystem::is_regular_file(status)) refuse("a device or pipe", "a file");
  const std::uintmax_t bytes = std::filesystem::file_size(path, error);
  if (error) refuse(error.message(), "a file that can be read");
  if (bytes > max_bytes) refuse(fmt::format("{} bytes", bytes), fmt::format("at most {} bytes", max_bytes));
  std::ifstream file(path, std::ios::binary);
  std::string text(static_cast<std::size_t>(bytes), '\0');
  file.read(text.data(), static_cast<std::streamsize>(bytes));
  if (!file) refuse("a file that cannot be read", "one with permission to read");
  if (text.empty()) refuse("an empty file", "a scene or model");
  return text;
}

}  // namespace ps
