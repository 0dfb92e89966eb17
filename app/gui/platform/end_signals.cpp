#include "gui/platform/end_signals.h"

#include <atomic>
#include <csignal>
#include <thread>

#include <unistd.h>

#include "gui/platform/window.h"

namespace ps::gui {
namespace {

std::atomic<int> signal_that_came{0};

bool is_ignored(int number) {
  struct sigaction action {};
  return sigaction(number, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

}  // namespace

void watch_end_signals() {
  sigset_t watched;
  sigemptyset(&watched);
  bool any = false;
  for (const int number : {SIGTERM, SIGHUP}) {
    if (is_ignored(number)) continue;
    sigaddset(&watched, number);
    any = true;
  }
  if (!any) return;
  pthread_sigmask(SIG_BLOCK, &watched, nullptr);  // all threads inherit this, so that only the one below gets them
  std::thread([watched] {
    int number = 0;
    if (sigwait(&watched, &number) != 0) return;
    signal_that_came = number;
    Window::wake();
    std::signal(SIGTERM, SIG_DFL);
    std::signal(SIGHUP, SIG_DFL);
    pthread_sigmask(SIG_UNBLOCK, &watched, nullptr);
    while (true) pause();  // here a second one arrives
  }).detach();
}

int end_signal() { return signal_that_came; }

}  // namespace ps::gui
