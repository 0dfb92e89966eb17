#include "base/read_file.h"

#include <cerrno>
#include <cstdio>
#include <memory>
#include <string_view>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "base/archived_file.h"
#include "base/check.h"

namespace ps {
namespace {

[[noreturn]] void refuse_input(const std::filesystem::path& path, std::string_view reason) {
  throw InputError(fmt::format("{}: {}", path.string(), reason));
}

[[noreturn]] void fail_to_read(const std::filesystem::path& path, int error) {
  refuse_input(path, fmt::format("cannot be read ({})", std::generic_category().message(error)));
}

}  // namespace

std::string read_whole_file(const std::filesystem::path& path, std::uintmax_t max_bytes) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  const auto refuse_large = [&](std::uintmax_t bytes) {
    if (bytes > max_bytes) refuse_input(path, fmt::format("has {} bytes, expected at most {}", bytes, max_bytes));
  };
  if (!std::filesystem::exists(status)) {
    auto archived = archived_file(path);
    if (!archived) refuse_input(path, "no such file");
    refuse_large(archived->size());
    return std::move(*archived);
  }
  if (std::filesystem::is_directory(status)) refuse_input(path, "is a folder, expected a file");
  if (!std::filesystem::is_regular_file(status)) refuse_input(path, "is not a regular file");
  const auto size = std::filesystem::file_size(path, error);
  if (error) refuse_input(path, error.message());
  refuse_large(size);

  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rbe"), &std::fclose);
  if (!file) fail_to_read(path, errno);
  std::string bytes(static_cast<std::size_t>(size), '\0');
  bytes.resize(std::fread(bytes.data(), 1, bytes.size(), file.get()));
  if (std::ferror(file.get()) != 0) fail_to_read(path, errno);
  return bytes;
}

}  // namespace ps
