#pragma once
#include "student/compile_listing.h"
#include "student/result_bytes.h"

namespace ps {

/// What shuts the program off besides its limits.
enum class Isolation {
  bubblewrap_if_installed,  ///< sees no network and no files but its own and the system's libraries
  limits_only
};

struct RunOptions {
  LaunchLimits limits{};
  Isolation isolation = Isolation::bubblewrap_if_installed;
};

/// What a student's own listing made of a scene.
struct OwnRun {
  OwnResult result;
  std::string failure;    ///< why there is none, in a sentence or two; empty if there is one
  std::string text;       ///< the beginning of what it printed
  bool text_cut = false;  ///< it printed more
  double seconds = 0;
};

/// Runs it as a child process. What goes wrong there is in the result. Throws Cancelled, and InputError where it cannot
/// be started.
OwnRun run_listing(const ListingProgram& program, const BookScene& scene, const ListingTask& task,
                   const RunOptions& options = {}, const Progress* progress = nullptr);

/// Whether a program of ours can be run in bubblewrap on this machine; found out once.
bool bubblewrap_works();

}  // namespace ps
