// Signals end the command line while it builds a data structure, not only between tiles of a picture.
#include <gtest/gtest.h>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>

#include "base/atomic_file.h"
#include "support/emulated.h"
#include "support/run_cli.h"
#include "support/trials.h"

namespace ps {
namespace cli_signal_test {
namespace {

using namespace std::chrono_literals;
using test::ScratchFolder;

/// Its octree takes seconds to build: almost coincident teapots, 64 entries for each triangle.
std::string teapots_in_one_place() {
  std::ostringstream text;
  text << "model { name = t generator = teapot divisions = 8 }\nlight { type = ambient intensity = 0.5 }\n";
  for (int i = 0; i < 340; ++i) text << "instance { model = t position = (" << i << "e-9, 0, 9) }\n";
  return text.str();
}

struct Work {
  bool goes_on = false;  ///< the process has not ended
  double seconds = 0;    ///< of all processors that it has used so far
};

Work work_of(pid_t process) {
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
Work wait_for_work(pid_t process, double seconds) {
  Work work = work_of(process);
  for (int i = 0; i < 60000 && work.goes_on && work.seconds < seconds; ++i) {
    std::this_thread::sleep_for(2ms);
    work = work_of(process);
  }
  return work;
}

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

struct Ended {
  int status = -1;  ///< as waitpid() gives it
  bool in_time = false;
  double seconds = 0;  ///< of processors, all its life
};

/// Waits for the end of a process, and makes it end after two minutes.
Ended wait_for_end(pid_t process) {
  Ended ended;
  rusage used{};
  for (int i = 0; i < 12000 && !ended.in_time; ++i) {
    ended.in_time = wait4(process, &ended.status, WNOHANG, &used) == process;
    if (!ended.in_time) std::this_thread::sleep_for(10ms);
  }
  if (!ended.in_time) {
    kill(process, SIGKILL);
    wait4(process, &ended.status, 0, &used);
  }
  ended.seconds = seconds(used.ru_utime) + seconds(used.ru_stime);
  return ended;
}

pid_t start_render(const ScratchFolder& folder, const std::string& messages) {
  const std::string scene = folder.file("teapots.scene"), picture = folder.file("picture.png");
  const pid_t process = fork();
  if (process != 0) return process;
  if (std::freopen(messages.c_str(), "w", stderr) == nullptr) _exit(126);
  execl(PIXELSCOPE_BIN_DIR "/pixelscope-cli", "pixelscope-cli", "render", scene.c_str(), "--size", "8x8", "--set",
        "accelerator=octree", "--set", "octree-leaf=1", "--set", "octree-depth=16", "--out", picture.c_str(), nullptr);
  _exit(127);
}

/// A signal while the octree is built: the program says that it was stopped, and leaves the picture as it was before.
///
/// Without a handler it would die of the signal, without a word. If the octree did not listen, it would use processors
/// for seconds more; that is no matter of how busy the machine is.
void expect_end_by(int number) {
  constexpr double at_work = 0.8, at_most_after = 1.5;  // seconds of processors
  const ScratchFolder folder, messages;
  folder.write("teapots.scene", teapots_in_one_place());
  folder.write("picture.png", "the picture of before");
  const pid_t process = start_render(folder, messages.file("err"));
  ASSERT_GT(process, 0);
  const Work before = wait_for_work(process, at_work);
  EXPECT_TRUE(before.goes_on && before.seconds >= at_work) << before.seconds;
  kill(process, number);
  const Ended ended = wait_for_end(process);
  EXPECT_TRUE(ended.in_time);
  EXPECT_TRUE(WIFEXITED(ended.status) && WEXITSTATUS(ended.status) == 130) << ended.status;
  EXPECT_EQ(read_whole_file(messages.file("err")), "pixelscope-cli: stopped\n");
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"picture.png", "teapots.scene"}));
  EXPECT_EQ(read_whole_file(folder.file("picture.png")), "the picture of before");
  EXPECT_LT(ended.seconds - before.seconds, at_most_after) << number;
}

TEST(CliSignal, InterruptEndsTheBuildingOfAnOctree) {
  if (test::is_emulated()) GTEST_SKIP() << "the emulator gets the signals itself";
  if (test::trial_divisor > 1)
    GTEST_SKIP() << "an instrumented program needs seconds to begin and looks for leaks at its end";
  expect_end_by(SIGINT);
}

TEST(CliSignal, TerminationEndsTheBuildingOfAnOctree) {
  if (test::is_emulated()) GTEST_SKIP() << "the emulator gets the signals itself";
  if (test::trial_divisor > 1)
    GTEST_SKIP() << "an instrumented program needs seconds to begin and looks for leaks at its end";
  expect_end_by(SIGTERM);
}

}  // namespace
}  // namespace cli_signal_test
}  // namespace ps
