#include <fstream>
#include <utility>

#include <fmt/format.h>

#include "base/archived_file.h"
#include "scene/scene_file.h"

namespace ps {

std::string read_text_file(const std::filesystem::path& path, std::uintmax_t max_bytes) {
  const std::string name = path.string();
  const auto refuse = [&](const std::string& found, const std::string& expected) {
    throw InputError({name, 0, 0}, found, expected);
  };
  const auto refuse_large = [&](std::uintmax_t bytes) {
    if (bytes > max_bytes) refuse(fmt::format("{} bytes", bytes), fmt::format("at most {} bytes", max_bytes));
  };
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  std::string text;
  if (!std::filesystem::exists(status)) {
    auto archived = archived_file(path);
    if (!archived) refuse("no such file", "a file");
    refuse_large(archived->size());
    text = std::move(*archived);
  } else {
    if (std::filesystem::is_directory(status)) refuse("a folder", "a file");
    if (!std::filesystem::is_regular_file(status)) refuse("a device or pipe", "a file");
    const std::uintmax_t bytes = std::filesystem::file_size(path, error);
    if (error) refuse(error.message(), "a file that can be read");
    refuse_large(bytes);
    std::ifstream file(path, std::ios::binary);
    text.resize(static_cast<std::size_t>(bytes));
    file.read(text.data(), static_cast<std::streamsize>(bytes));
    if (!file) refuse("a file that cannot be read", "one with permission to read");
  }
  if (text.empty()) refuse("an empty file", "a scene or model");
  return text;
}

}  // namespace ps
