#include "cli/interrupt.h"

#include <sys/time.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <string_view>

#include "base/temporary_files.h"

namespace ps::cli {
namespace {

/// Has SIGALRM come when gentle ways have had their time.
void wait_a_moment() {
  constexpr suseconds_t patience = 700'000;  // microseconds
  const itimerval once{{}, {0, patience}};
  setitimer(ITIMER_REAL, &once, nullptr);
}

Progress own_progress;
std::atomic<Progress*> stopped_by_signals{nullptr};
std::atomic<bool> said{false};

/// Work that does not listen, such as a call of a graphics driver, may go on for as long as it likes.
extern "C" void stop_at_once(int) {
  if (has_temporary_files()) {
    wait_a_moment();
    return;
  }
  if (isatty(STDERR_FILENO) && write(STDERR_FILENO, "\n", 1) < 0) _exit(interrupted);  // below a line of progress
  say_stopped();
  _exit(interrupted);
}

extern "C" void stop_gently(int signal) {
  if (Progress* progress = stopped_by_signals) progress->request_stop();
  std::signal(signal, SIG_DFL);
  wait_a_moment();
}

}  // namespace

void say_stopped() {
  constexpr std::string_view words = "pixelscope-cli: stopped\n";
  if (said.exchange(true)) return;
  if (write(STDERR_FILENO, words.data(), words.size()) < 0) return;  // the reader has gone
}

void forward_interrupts(Progress& progress) {
  stopped_by_signals = &progress;
  std::signal(SIGALRM, stop_at_once);
  std::signal(SIGINT, stop_gently);
  std::signal(SIGTERM, stop_gently);
}

Progress& interruptible_progress() {
  forward_interrupts(own_progress);
  return own_progress;
}

}  // namespace ps::cli
