#pragma once
#include <sys/types.h>

#include <cstdint>
#include <vector>

namespace launch {

/// All processes that began below this one and still run.
struct Descendants {
  std::vector<pid_t> processes;
  std::uint64_t resident = 0;  ///< bytes of memory that they hold, together; shared pages count for each
};

/// Reads /proc. Processes whose parent ended count too, if this process takes such children over
/// (PR_SET_CHILD_SUBREAPER).
Descendants descendants();

/// Ends them all, those that left the group `group` as well, and collects what they leave. Answers whether nothing is
/// left.
bool end_descendants(pid_t group);

}  // namespace launch
