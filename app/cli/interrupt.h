#pragma once
#include "base/progress.h"

namespace ps::cli {

/// The progress of whatever the program is doing. Ctrl-C and SIGTERM ask it to stop, so that work ends with Cancelled
/// and no half-written file; a second Ctrl-C kills the program.
Progress& interruptible_progress();

/// The same for a progress that belongs to somebody else and outlives the work.
void forward_interrupts(Progress& progress);

}  // namespace ps::cli
