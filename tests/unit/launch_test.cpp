// Programs that are started with limits: whatever they do, they end, with all that they started, and only what they may
// write comes back. The programs here are lines for the shell.
#include "student/launch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <thread>

#include "base/read_file.h"
#include "support/refusal.h"
#include "support/run_cli.h"

namespace ps::launch_test {
namespace {
using test::ScratchFolder;

LaunchLimits short_limits() {
  return {.processor_seconds = 1, .seconds = 30, .memory = 256 << 20, .text_bytes = 4 << 20, .result_bytes = 1000};
}

Launched shell(const std::string& line, const LaunchLimits& limits = short_limits(),
               const Progress* progress = nullptr) {
  const ScratchFolder folder;
  give_to_nobody(folder.path());
  return launch({.command = {"/bin/sh", "-c", line},
                 .environment = {},
                 .folder = folder.path(),
                 .input = {},
                 .limits = limits,
                 .rights = LaunchRights::nobody_for_root},
                progress);
}

/// How many processes have this word among their arguments.
int processes_with(const std::string& word) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    std::ifstream file(entry.path() / "cmdline", std::ios::binary);
    std::string arguments((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    std::replace(arguments.begin(), arguments.end(), '\0', ' ');
    if (arguments.find(word) != std::string::npos) ++count;
  }
  return count;
}

/// The same once what was killed has gone, for which the system takes a moment where much else is running.
int processes_left_with(const std::string& word) {
  for (int tries = 0; tries < 500 && processes_with(word) > 0; ++tries)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  return processes_with(word);
}

TEST(Launch, ExitStatusTextAndResultComeBack) {
  const Launched done = shell("echo out; echo err >&2; printf result >&3; exit 7");
  EXPECT_EQ(done.end, LaunchEnd::exited);
  EXPECT_EQ(done.status, 7);
  EXPECT_EQ(done.text, "out\nerr\n");
  EXPECT_EQ(done.result, "result");
}

TEST(Launch, NothingOfThisProcessIsInherited) {
  const Launched done = shell("env; echo; ls /proc/self/fd; cat");
  EXPECT_EQ(done.text.find("HOME="), std::string::npos);
  EXPECT_EQ(done.text.find("PATH="), std::string::npos);
  EXPECT_NE(done.text.find("\n0\n1\n2\n3\n4\n"), std::string::npos) << done.text;  // 4 is the folder that ls lists
  EXPECT_EQ(done.text.find("\n5\n"), std::string::npos) << done.text;
  EXPECT_NE(shell("grep NoNewPrivs /proc/self/status").text.find('1'), std::string::npos);
}

TEST(Launch, LoopsEnd) {
  EXPECT_EQ(shell("while :; do :; done").end, LaunchEnd::processor_time);
  LaunchLimits limits = short_limits();
  limits.seconds = 0.3;
  EXPECT_EQ(shell("sleep 60", limits).end, LaunchEnd::time);
}

TEST(Launch, SignalsAreNamed) {
  const Launched done = shell("kill -SEGV $$");
  EXPECT_EQ(done.end, LaunchEnd::signalled);
  EXPECT_EQ(done.status, SIGSEGV);
}

/// The system refuses the next one, or, where it does not count for this user, all are ended.
bool was_stopped(const Launched& launched) {
  return launched.end == LaunchEnd::processes || launched.text.find("fork") != std::string::npos;
}

TEST(Launch, MoreProcessesThanAllowedAreNotStarted) {
  LaunchLimits limits = short_limits();
  limits.processes = 20;
  limits.seconds = 1;
  EXPECT_TRUE(was_stopped(shell("bomb() { bomb | bomb & }; bomb; sleep 62", limits)));
  EXPECT_EQ(processes_with("sleep 62"), 0);
  EXPECT_EQ(processes_with("bomb | bomb"), 0);
  const std::string twenty_five = "for i in 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23 24 25; do ";
  EXPECT_TRUE(was_stopped(shell(twenty_five + "sleep 61 & done; wait", limits)));
  EXPECT_EQ(processes_with("sleep 61"), 0);
  limits.processes = 40;
  EXPECT_FALSE(was_stopped(shell(twenty_five + "sleep 0.1 & done; wait", limits)));
}

/// One that leaves the group and whose parent ends is still found.
TEST(Launch, NoOrphanStays) {
  const Launched done = shell("setsid /bin/sh -c 'sleep 60 # pixelscope-orphan' & (setsid /bin/sh -c 'sleep 60 # "
                              "pixelscope-orphan' &) ; sleep 0.2; exit 0");
  EXPECT_EQ(done.end, LaunchEnd::exited);
  EXPECT_EQ(processes_with("pixelscope-orphan"), 0);
}

/// Without isolation a program may stop any process of its user, its launcher too. The caller's clock ends both.
TEST(Launch, AStoppedLauncherIsEnded) {
  const ScratchFolder folder;
  LaunchLimits limits = short_limits();
  limits.seconds = 0.5;
  const Launch what{.command = {"/bin/sh", "-c", "kill -STOP $PPID; sleep 60 # pixelscope-stopper"},
                    .environment = {},
                    .folder = folder.path(),
                    .input = {},
                    .limits = limits,
                    .rights = LaunchRights::own};
  const Launched done = launch(what);
  EXPECT_EQ(done.end, LaunchEnd::time);
  EXPECT_LT(done.seconds, 20);
  EXPECT_EQ(processes_left_with("pixelscope-stopper"), 0);
  EXPECT_EQ(processes_left_with(folder.path().string()), 0) << "the launcher has its folder as an argument";
}

TEST(Launch, CancellingEndsAStoppedLauncher) {
  const ScratchFolder folder;
  Progress progress;
  std::thread asks([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    progress.request_stop();
  });
  const Launch what{.command = {"/bin/sh", "-c", "kill -STOP $PPID; sleep 60 # pixelscope-cancelled"},
                    .environment = {},
                    .folder = folder.path(),
                    .input = {},
                    .limits = short_limits(),
                    .rights = LaunchRights::own};
  EXPECT_THROW(launch(what, &progress), Cancelled);
  asks.join();
  EXPECT_EQ(processes_left_with("pixelscope-cancelled"), 0);
}

TEST(Launch, EnormousOutputIsCut) {
  const Launched text = shell("exec yes 0123456789012345678901234567890123456789");
  EXPECT_EQ(text.end, LaunchEnd::text);
  EXPECT_TRUE(text.text_cut);
  EXPECT_LE(text.text.size(), 64u << 10);
  const Launched result = shell("exec yes >&3");
  EXPECT_EQ(result.end, LaunchEnd::result);
  EXPECT_LE(result.result.size(), 100'000u);
}

TEST(Launch, MemoryAndFilesHaveAnEnd) {
  // Each of the four holds less than it may, all together more.
  LaunchLimits limits = short_limits();
  limits.memory = 64 << 20;
  limits.processor_seconds = 10;
  EXPECT_EQ(
      shell("for i in 1 2 3 4; do head -c 30000000 /dev/zero | tail -c 29000000 >/dev/full & done; for i in 1 2 3 "
            "4 5 6; do (x=$(head -c 20000000 /dev/zero | tr '\\0' x); sleep 5) & done; wait",
            limits)
          .end,
      LaunchEnd::memory);
  limits = short_limits();
  limits.file_bytes = 1 << 20;
  EXPECT_NE(shell("head -c 4000000 /dev/zero >big; stat -c %s big", limits).text.find("1048576\n"), std::string::npos);
}

// No file is larger than it may be: only together they are too large, or too many.
TEST(Launch, ManySmallFilesHaveAnEnd) {
  LaunchLimits limits = short_limits();
  limits.processor_seconds = 10;
  limits.file_bytes = 1 << 20;
  const std::string three = "mkdir a; for i in 1 2 3; do head -c 300000 /dev/zero >a/$i; done; sleep 0.2";
  EXPECT_EQ(shell(three, limits).end, LaunchEnd::exited);
  EXPECT_EQ(shell(three + "; head -c 300000 /dev/zero >4; sleep 60", limits).end, LaunchEnd::files);
  EXPECT_EQ(shell("i=0; while :; do : >$i; i=$((i+1)); done", limits).end, LaunchEnd::files) << "empty ones";
}

TEST(Launch, ACancelledOneEndsWithAllThatItStarted) {
  Progress progress;
  std::thread canceller([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    progress.request_stop();
  });
  EXPECT_THROW(shell("(sleep 60; : pixelscope-cancelled) & /bin/sh -c 'sleep 60; : pixelscope-cancelled'",
                     short_limits(), &progress),
               Cancelled);
  canceller.join();
  EXPECT_EQ(processes_left_with("pixelscope-cancelled"), 0);
}

TEST(Launch, AProgramThatIsNotThereIsAMessage) {
  EXPECT_NE(
      test::refusal_of([&] {
        launch(
            {.command = {"/nowhere/program"}, .environment = {}, .folder = "/", .input = {}, .limits = short_limits()});
      }).find("/nowhere/program cannot be started"),
      std::string::npos);
}

// As everything is that lies in a folder mounted with `noexec`.
TEST(Launch, AFileThatIsNoProgramIsAMessage) {
  const test::ScratchFolder folder;
  EXPECT_NE(test::refusal_of([&] {
              launch({.command = {folder.write("text", "#")},
                      .environment = {},
                      .folder = "/",
                      .input = {},
                      .limits = short_limits()});
            }).find("TMPDIR names another"),
            std::string::npos);
}

}  // namespace
}  // namespace ps::launch_test
