// How far a long call is, in one line of a terminal. The terminal is a pseudo terminal of this test.
#include "base/progress_line.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>

#include "support/run_cli.h"

namespace ps::progress_line_test {
namespace {

/// What was written to the terminal whose other side is `master`, so far.
std::string written(int master) {
  std::string text;
  char bytes[1000];
  for (ssize_t size = 0; (size = read(master, bytes, sizeof bytes)) > 0;)
    text.append(bytes, static_cast<std::size_t>(size));
  return text;
}

TEST(ProgressLine, IsRewrittenOnATerminalAndRemoved) {
  const int master = posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK);
  if (master < 0 || grantpt(master) != 0 || unlockpt(master) != 0) GTEST_SKIP() << "there is no pseudo terminal here";
  const int terminal = open(ptsname(master), O_RDWR | O_NOCTTY);
  ASSERT_GE(terminal, 0);
  std::string text;
  {
    Progress progress;
    progress.expect(200);
    progress.advance(84);
    const ProgressLine line(progress, "rendering", terminal);
    const auto begin = std::chrono::steady_clock::now();
    while (text.find("rendering  42 %") == std::string::npos) {
      ASSERT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(30)) << text;
      usleep(20000);
      text += written(master);
    }
  }
  text = written(master);
  EXPECT_TRUE(text.ends_with("\r               \r")) << "the line is not empty in the end";
  close(terminal);
  close(master);
}

TEST(ProgressLine, WritesNothingIntoAPipe) {
  int pipe_ends[2];
  ASSERT_EQ(pipe2(pipe_ends, O_NONBLOCK), 0);
  {
    Progress progress;
    const ProgressLine line(progress, "rendering", pipe_ends[1]);
    usleep(900000);
  }
  EXPECT_EQ(written(pipe_ends[0]), "");
  close(pipe_ends[0]);
  close(pipe_ends[1]);
}

// The command is ended as soon as it has said how far it is.
TEST(ProgressLine, RenderShowsItOnATerminal) {
  const int master = posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK);
  if (master < 0 || grantpt(master) != 0 || unlockpt(master) != 0) GTEST_SKIP() << "there is no pseudo terminal here";
  const int terminal = open(ptsname(master), O_RDWR | O_NOCTTY);
  const test::ScratchFolder folder;
  const std::string out = folder.file("out.png");
  const pid_t child = fork();
  if (child == 0) {
    dup2(terminal, STDERR_FILENO);
    execl(PIXELSCOPE_BIN_DIR "/pixelscope-cli", "pixelscope-cli", "render", "cgfs/reflections", "--size", "1500x1500",
          "--set", "samples-per-pixel=4096", "--out", out.c_str(), nullptr);
    _exit(127);
  }
  std::string text;
  const auto begin = std::chrono::steady_clock::now();
  while (text.find(" %") == std::string::npos && std::chrono::steady_clock::now() - begin < std::chrono::seconds(30)) {
    usleep(20000);
    text += written(master);
  }
  kill(child, SIGINT);
  waitpid(child, nullptr, 0);
  close(terminal);
  close(master);
  EXPECT_TRUE(text.starts_with("\rrendering ")) << text;
}

}  // namespace
}  // namespace ps::progress_line_test
