#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/progress.h"

namespace ps {

/// A hint where the system does not let a program start: temporary folders may be mounted with `noexec`.
inline constexpr std::string_view folder_hint = "; may programs start in its folder? TMPDIR names another";

/// Limits of a program that is started, and of all that it starts. A program that exceeds one of them is ended, with
/// everything that began below it. These limits stop mistakes. Without isolation, a program that means harm can leave
/// shared memory and files outside its folder behind, or end its launcher and go on without limits.
struct LaunchLimits {
  double processor_seconds = 10;                  ///< of each process, in whole seconds
  double seconds = 20;                            ///< by the clock
  std::uint64_t memory = std::uint64_t{1} << 30;  ///< bytes: of each process's addresses, and resident in all of them
  int processes = 64;                             ///< at once
  std::uint64_t file_bytes = std::uint64_t{64} << 20;  ///< of each file that it writes, and of all below its folder
  std::uint64_t text_bytes = std::uint64_t{16} << 20;  ///< on standard output and standard error
  std::uint64_t result_bytes = 0;                      ///< on descriptor 3
};

/// Whose rights a program gets. Root may start any number of processes, so a limit needs another user.
enum class LaunchRights { own, nobody_for_root };

struct Launch {
  std::vector<std::string> command;      ///< the path of the program, then its arguments
  std::vector<std::string> environment;  ///< all of it: "NAME=VALUE"
  std::filesystem::path folder;          ///< where it runs; nobody else writes there
  std::filesystem::path input;           ///< the file that it finds as its standard input; empty: no input
  LaunchLimits limits;
  LaunchRights rights = LaunchRights::own;
};

/// Gives a folder and all in it to the user who gets a program of root's with LaunchRights::nobody_for_root. Does
/// nothing for other users.
void give_to_nobody(const std::filesystem::path& folder);

/// How a launched program ended.
enum class LaunchEnd {
  exited,
  signalled,
  processor_time,
  time,
  memory,
  processes,
  files,   ///< all below its folder took more than file_bytes, or were too many to count
  text,    ///< it wrote more than text_bytes
  result,  ///< it wrote more than result_bytes
};

struct Launched {
  LaunchEnd end = LaunchEnd::exited;
  int status = 0;         ///< exit status, or the number of the signal
  std::string text;       ///< the beginning of what it wrote on standard output and standard error
  bool text_cut = false;  ///< there was more
  std::string result;     ///< what it wrote on descriptor 3
  double seconds = 0;     ///< how long it took
};

/// Starts a program in a process group of its own, without rights that it could gain, without descriptors beside 0 to
/// 3, and waits until it and all that it started have ended. Throws Cancelled when `progress` is asked to stop,
/// InputError when the program cannot be started.
Launched launch(const Launch& what, const Progress* progress = nullptr);

}  // namespace ps
