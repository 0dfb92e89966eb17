#pragma once
#include <filesystem>
#include <string>
#include <string_view>

namespace ps {

/// Writes `bytes` as the whole content of `path`: first into a temporary file in the same folder, which is then
/// renamed, so that `path` holds either its old content or all of the new. Throws InputError, naming the file and the
/// reason, if the folder does not exist or cannot be written; the old file is then untouched.
void write_file_atomically(const std::filesystem::path& path, std::string_view bytes);

/// All bytes of a file. Throws InputError if it is missing, not a regular file, unreadable, or larger than `max_bytes`.
std::string read_whole_file(const std::filesystem::path& path, std::uintmax_t max_bytes = std::uintmax_t{1} << 32);

}  // namespace ps
