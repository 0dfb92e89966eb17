#pragma once
#include "base/progress.h"

namespace ps::cli {

constexpr int interrupted = 130;  ///< the exit status of a command that was stopped

/// The progress of whatever the program is doing. Ctrl-C and SIGTERM ask it to stop, so that work ends with Cancelled
/// and no half-written file. What has not ended within a second is ended, but for a file that is being written. A
/// second Ctrl-C kills the program.
Progress& interruptible_progress();

/// The same for a progress that belongs to somebody else and outlives the work.
void forward_interrupts(Progress& progress);

/// "pixelscope-cli: stopped" on standard error, once. Signal handlers may call it.
void say_stopped();

}  // namespace ps::cli
