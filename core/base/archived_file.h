#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace ps {

// A path may lead into an archive: "mine.tar/models/die.obj" is a file of mine.tar. Archives are read into memory, and
// never unpacked.

/// The extension of archives.
inline constexpr const char* archive_extension = ".tar";
inline constexpr std::uintmax_t largest_archive = 100'000'000;  // bytes

/// The content of such a file; nullopt where the path leads into no archive, or to none of its files. Throws InputError
/// for an archive that cannot be read.
std::optional<std::string> archived_file(const std::filesystem::path& path);

/// The names of the files that an archive holds, sorted. Throws InputError.
std::vector<std::string> names_in_archive(const std::filesystem::path& archive);

/// The names of files and folders that lie in a folder of an archive; empty for any other folder.
std::vector<std::string> names_in_archived_folder(const std::filesystem::path& folder);

/// The file on the disk that holds what the path names: the archive for a path into one, else the path itself.
std::filesystem::path file_on_disk(const std::filesystem::path& path);

/// Whether the path names a regular file, on the disk or in an archive that can be read.
bool is_any_file(const std::filesystem::path& path);

}  // namespace ps
