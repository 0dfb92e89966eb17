#pragma once
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>

namespace ps::test {

/// What a process has done so far.
struct Work {
  bool goes_on = false;  ///< the process has not ended
  double seconds = 0;    ///< of all processors that it has used so far
};

/// The process is a child of this one.
inline Work work_of(pid_t process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/stat");
  std::string text;
  std::getline(file, text);
  const auto name_end = text.rfind(')');
  if (name_end == std::string::npos) return {};
  std::istringstream fields(text.substr(name_end + 1));
  std::string state, skipped;
  fields >> state;
  for (int i = 0; i < 10; ++i) fields >> skipped;
  double user = 0, system = 0;
  fields >> user >> system;
  return {state != "Z", (user + system) / static_cast<double>(sysconf(_SC_CLK_TCK))};
}

/// Waits until the process has used so much, or has ended.
inline Work wait_for_work(pid_t process, double seconds) {
  Work work = work_of(process);
  for (int i = 0; i < 60000 && work.goes_on && work.seconds < seconds; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    work = work_of(process);
  }
  return work;
}

inline double seconds_of(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

/// How a process ended.
struct Ended {
  int status = -1;  ///< as waitpid() gives it
  bool in_time = false;
  double seconds = 0;  ///< of processors, all its life
};

/// Waits for the end of a process, and makes it end after two minutes.
inline Ended wait_for_end(pid_t process) {
  Ended ended;
  rusage used{};
  for (int i = 0; i < 12000 && !ended.in_time; ++i) {
    ended.in_time = wait4(process, &ended.status, WNOHANG, &used) == process;
    if (!ended.in_time) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  if (!ended.in_time) {
    kill(process, SIGKILL);
    wait4(process, &ended.status, 0, &used);
  }
  ended.seconds = seconds_of(used.ru_utime) + seconds_of(used.ru_stime);
  return ended;
}

}  // namespace ps::test
