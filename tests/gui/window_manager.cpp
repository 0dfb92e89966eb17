#include "gui/window_manager.h"

#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <thread>

namespace ps::test {

bool WindowManager::available() {
  return std::system("command -v openbox >/dev/null 2>&1 && command -v xdotool >/dev/null 2>&1") == 0;
}

WindowManager::WindowManager() {
  const std::string config = std::filesystem::absolute("tests/gui/files/openbox.xml");  // openbox finds no other path
  process_ = fork();
  if (process_ == 0) {
    execlp("openbox", "openbox", "--config-file", config.c_str(), nullptr);
    _exit(127);
  }
  // It runs once it has said how many desktops there are.
  for (int i = 0; i < 600; ++i) {
    if (std::system("xdotool get_num_desktops >/dev/null 2>&1") == 0) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  kill(process_, SIGKILL);
  waitpid(process_, nullptr, 0);
  process_ = -1;
}

WindowManager::~WindowManager() {
  if (process_ <= 0) return;
  kill(process_, SIGTERM);
  waitpid(process_, nullptr, 0);
}

}  // namespace ps::test
