#include "cli/interrupt.h"

#include <atomic>
#include <csignal>

namespace ps::cli {
namespace {

Progress own_progress;
std::atomic<Progress*> stopped_by_signals{nullptr};

extern "C" void stop_gently(int signal) {
  if (Progress* progress = stopped_by_signals) progress->request_stop();
  std::signal(signal, SIG_DFL);
}

}  // namespace

void forward_interrupts(Progress& progress) {
  stopped_by_signals = &progress;
  std::signal(SIGINT, stop_gently);
  std::signal(SIGTERM, stop_gently);
}

Progress& interruptible_progress() {
  forward_interrupts(own_progress);
  return own_progress;
}

}  // namespace ps::cli
