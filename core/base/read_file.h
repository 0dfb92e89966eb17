#pragma once
#include <cstdint>
#include <filesystem>
#include <string>

namespace ps {

/// All bytes of a file, which may lie in an archive (base/archived_file.h). Throws InputError if it is missing, not a
/// regular file, unreadable, or larger than `max_bytes`.
std::string read_whole_file(const std::filesystem::path& path, std::uintmax_t max_bytes = std::uintmax_t{1} << 32);

}  // namespace ps
