#include "cli/interrupt.h"

#include <csignal>

namespace ps::cli {
namespace {

Progress progress;

extern "C" void stop_gently(int signal) {
  progress.request_stop();
  std::signal(signal, SIG_DFL);
}

}  // namespace

Progress& interruptible_progress() {
  std::signal(SIGINT, stop_gently);
  std::signal(SIGTERM, stop_gently);
  return progress;
}

}  // namespace ps::cli
