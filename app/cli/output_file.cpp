#include "cli/output_file.h"

#include <fmt/format.h>

#include <system_error>

#include "base/atomic_file.h"
#include "base/check.h"
#include "base/extension.h"
#include "base/output_target.h"

namespace ps::cli {

void require_output_file(const std::string& path, OutputKind kind) {
  output_target(path);
  if (kind == OutputKind::any) return;
  const std::string extension = lower_extension(path);
  const bool floats = kind == OutputKind::picture && extension == ".pfm";
  if (extension != ".png" && extension != ".ppm" && !floats)
    throw InputError(fmt::format("{}: found the extension '{}', expected {}", path, extension,
                                 kind == OutputKind::levels ? ".png or .ppm" : ".png, .ppm or .pfm"));
}

void write_result(const std::string& text, const std::string& out) {
  if (out.empty())
    fmt::print("{}", text);
  else
    write_file_atomically(out, text);
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (!std::filesystem::is_directory(folder, error))
    throw InputError(fmt::format("{}: cannot be made a folder", folder.string()));
}

}  // namespace ps::cli
