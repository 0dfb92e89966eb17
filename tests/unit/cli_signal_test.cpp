// Signals end the command line while it builds a data structure, not only between tiles of a picture.
#include <gtest/gtest.h>

#include <unistd.h>

#include <csignal>
#include <sstream>
#include <string>

#include "base/atomic_file.h"
#include "support/child_process.h"
#include "support/emulated.h"
#include "support/run_cli.h"
#include "support/trials.h"

namespace ps::cli_signal_test {
namespace {

using test::Ended;
using test::ScratchFolder;
using test::wait_for_end;
using test::wait_for_work;
using test::Work;

/// Its octree takes seconds to build: almost coincident teapots, 64 entries for each triangle.
std::string teapots_in_one_place() {
  std::ostringstream text;
  text << "model { name = t generator = teapot divisions = 8 }\nlight { type = ambient intensity = 0.5 }\n";
  for (int i = 0; i < 340; ++i) text << "instance { model = t position = (" << i << "e-9, 0, 9) }\n";
  return text.str();
}

/// What does not listen is ended within a second of the signal; not so in this process and what it becomes.
void hold_back_the_alarm() {
  sigset_t alarm_alone;
  sigemptyset(&alarm_alone);
  sigaddset(&alarm_alone, SIGALRM);
  sigprocmask(SIG_BLOCK, &alarm_alone, nullptr);
}

pid_t start_render(const ScratchFolder& folder, const std::string& messages) {
  const std::string scene = folder.file("teapots.scene"), picture = folder.file("picture.png");
  const pid_t process = fork();
  if (process != 0) return process;
  hold_back_the_alarm();
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
}  // namespace ps::cli_signal_test
