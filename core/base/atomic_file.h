#pragma once
#include <filesystem>
#include <string_view>

#include "base/read_file.h"

namespace ps {

/// Whether a file must still be whole after a power cut, which takes as long as the disk needs (milliseconds).
enum class Durability {
  synced,  ///< the bytes are on the disk before the name is theirs, and the name is before the function returns
  quick,   ///< for what is written many times a second and only helps after a crash of the program
};

/// Writes `bytes` as the whole content of `path`. What is written depends on what the path names; links are followed.
///
/// - A regular file, or none yet: the bytes go into a temporary file in the same folder, which then takes the name,
///   so that the path holds either its old content or all of the new. The new file keeps the permissions, and as far as
///   the system lets the user, owner and group of the old one. Other hard links to the old file keep the old content:
///   they may be somebody's backup.
/// - A character device or a pipe: the bytes are written into it, for it is a place to send data to and must stay. A
///   pipe without a reader is waited for, 10 seconds at most.
/// - The program's own standard output or error (/dev/stdout): the bytes follow what was printed so far.
///
/// Throws InputError, naming the file and the reason, where that is not possible; a regular file is then as before.
/// A path that output_target() refuses is refused before anything is written.
void write_file_atomically(const std::filesystem::path& path, std::string_view bytes,
                           Durability durability = Durability::synced);

}  // namespace ps
