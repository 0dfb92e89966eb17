#pragma once
#include "student/compile_listing.h"
#include "student/result_bytes.h"

namespace ps {

struct RunOptions {
  LaunchLimits limits{};
  Isolation isolation = Isolation::bubblewrap_if_installed;
};

/// The result of a student's own listing for a scene.
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

}  // namespace ps
