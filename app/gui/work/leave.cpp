#include "gui/work/leave.h"

#include <unistd.h>

#include <chrono>
#include <iostream>
#include <thread>

namespace ps::gui {

void leave_soon(int status) {
  constexpr std::chrono::milliseconds patience{200};
  std::cout.flush();
  std::thread([status, patience] {
    std::this_thread::sleep_for(patience);
    _exit(status);
  }).detach();
}

}  // namespace ps::gui
