#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ps {

/// A file of an archive.
struct TarEntry {
  std::string name;  ///< relative, parts separated by /
  std::string bytes;
};

/// The files as an archive in the ustar format (POSIX.1-1988) with GNU's long names, which every tar and archive
/// manager opens; without owner and time, so that equal files make equal archives.
std::string tar_bytes(std::span<const TarEntry> entries);

/// The files of an archive as tar writes it (ustar, GNU or pax); folders are left out. Throws InputError, naming
/// `archive`, for bytes that are not an archive, one that is cut off, a link or device, and a name that leads out of
/// the archive.
std::vector<TarEntry> read_tar(std::string_view bytes, const std::string& archive);

}  // namespace ps
