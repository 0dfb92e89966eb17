// The command line ends while a graphics driver takes minutes.
#include <gtest/gtest.h>

#include <csignal>
#include <string>

#include "agreement/hardware/hardware_pair.h"
#include "base/read_file.h"
#include "support/child_process.h"
#include "support/emulated.h"
#include "support/slow_shaders.h"

namespace ps::slow_driver_test {
namespace {

pid_t start_render(const std::string& picture, const std::string& messages) {
  const pid_t process = fork();
  if (process != 0) return process;
  if (std::freopen(messages.c_str(), "w", stderr) == nullptr) _exit(126);
  execl(PIXELSCOPE_BIN_DIR "/pixelscope-cli", "pixelscope-cli", "render", "cgfs/shading", "--size", "16x16", "--set",
        "renderer=hardware", "--out", picture.c_str(), nullptr);
  _exit(127);
}

TEST(SlowDriver, TheFirstInterruptEndsTheCommand) {
  PS_NEEDS_HARDWARE(hardware);
  if (test::is_emulated()) GTEST_SKIP() << "the emulator gets the signals itself";
  constexpr double at_work = 2;  // seconds of processors: it has begun to compile
  const test::SlowShaders shaders;
  const test::ScratchFolder folder;
  for (const int number : {SIGINT, SIGTERM}) {
    const pid_t process = start_render(folder.file("picture.png"), folder.file("err"));
    ASSERT_GT(process, 0);
    EXPECT_TRUE(test::wait_for_work(process, at_work).goes_on);
    kill(process, number);
    const test::Ended ended = test::wait_for_end(process);
    EXPECT_TRUE(ended.in_time);
    EXPECT_TRUE(WIFEXITED(ended.status) && WEXITSTATUS(ended.status) == 130) << ended.status;
    const std::string said = read_whole_file(folder.file("err"));
    EXPECT_TRUE(said.ends_with("pixelscope-cli: stopped\n")) << said;
    EXPECT_EQ(folder.names(), std::vector<std::string>{"err"});
  }
}

}  // namespace
}  // namespace ps::slow_driver_test
