#pragma once
#include <filesystem>
#include <string_view>
#include <vector>

#include "student/launch.h"

namespace ps {

/// The confinement of a program besides its limits.
enum class Isolation {
  bubblewrap_if_installed,  ///< sees no network and no files but its own and the system's programs and libraries
  limits_only
};

/// launch(), in bubblewrap where `isolation` allows it and it works on this machine: the program then sees the system's
/// programs and libraries, its folder, which alone it can write to, and the files or folders `readable`. A program of
/// root's gets another user's rights. Exit status, signal and errors are as launch() returns them.
Launched launch_isolated(Launch what, const std::vector<std::filesystem::path>& readable, Isolation isolation,
                         const Progress* progress);

/// Whether a program can be run in bubblewrap on this machine; found out once.
bool bubblewrap_works();

/// One sentence for people: what holds for the programs of students on this machine.
std::string_view protection_sentence();

}  // namespace ps
