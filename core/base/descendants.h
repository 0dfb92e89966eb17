#pragma once
#include <sys/types.h>

#include <cstdint>
#include <vector>

/// The processes below another one, as /proc lists them. No other part of Pixelscope is used here: pixelscope-launch
/// links this file too.
namespace ps {

/// All processes that began below a process and still run.
struct Descendants {
  std::vector<pid_t> processes;
  std::uint64_t resident = 0;  ///< bytes of memory that they hold, together; shared pages count for each
};

/// Those below `root`. Processes whose parent ended count too, if `root` takes such children over
/// (PR_SET_CHILD_SUBREAPER).
Descendants descendants(pid_t root);

/// Ends all below `root`, and the processes of `group` if it is above 0. Collects what they leave where `root` is this
/// process. Returns whether none is left; gives up after some 2 seconds.
bool end_descendants(pid_t root, pid_t group = 0);

}  // namespace ps
