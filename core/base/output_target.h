#pragma once
#include <filesystem>

#include <sys/types.h>

namespace ps {

/// The target of a path that is to be written, links followed.
struct OutputTarget {
  enum class Way {
    replace,  ///< a regular file or none yet: a new file takes the name
    into,     ///< a character device, a pipe, or a file that is open already: the bytes go into it
    stream,   ///< the program's own standard output or standard error, by a name such as /dev/stdout
  };
  Way way = Way::replace;
  std::filesystem::path path;  ///< where the links lead; of a stream: the path as given
  int stream = -1;             ///< file descriptor of a stream
  bool exists = false;         ///< a regular file that is replaced; the next three are its own
  mode_t mode = 0;             ///< permission bits
  uid_t owner = 0;
  gid_t group = 0;
};

/// Finds that out, and checks what can be checked before there is anything to write. Throws InputError, naming `path`
/// and the reason, where it cannot be written: the folder is missing or write-protected, the path is a folder, a disk
/// or a socket, links lead in a circle, or the file is write-protected. A file without any permission to write is
/// refused for the superuser, too: somebody has marked it as not to be changed.
OutputTarget output_target(const std::filesystem::path& path);

}  // namespace ps
