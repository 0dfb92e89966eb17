// Output that cannot be printed is a failure of every command, whether the disk is full or nobody reads any more.
#include <gtest/gtest.h>

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <sstream>
#include <utility>

#include "base/atomic_file.h"
#include "document/command_line.h"
#include "support/emulated.h"
#include "support/run_cli.h"
#include "support/trials.h"

namespace ps::standard_output_test {
namespace {

using test::run_cli;
using test::ScratchFolder;

const std::vector<std::vector<std::string>>& printing_commands() {
  static const std::vector<std::vector<std::string>> commands{
      {"--help"},
      {"--version"},
      {"render", "--help"},
      {"options"},
      {"options", "--json"},
      {"scenes"},
      {"lessons"},
      {"lessons", "show", "cgfs_02_basic_ray_tracing"},
      {"inspect", "cgfs/lens", "--size", "9x9", "--pixel", "3,3"},
      {"inspect", "cgfs/lens", "--size", "9x9", "--pixel", "3,3", "--json"},
      {"inspect", "cgfs/lens", "--size", "9x9", "--pixel", "3,3", "--svg", "microscope"},
      {"inspect", "cgfs/cubes", "--size", "9x9", "--pixel", "3,3", "--vertex", "nearest"},
      {"precision", "cgfs/lens", "--size", "9x9"},
      {"causes", "cgfs/lens", "--size", "9x9", "--set-b", "gamma=2"},
      {"needs", "cgfs/lines", "--size", "9x9", "--repeats", "1"},
      {"stability", "epsilon-unit", "--effort", "0.01"}};
  return commands;
}

/// Runs the program by a shell, with `redirection` behind its arguments; gives its status and its messages.
std::pair<int, std::string> run_by_shell(const std::vector<std::string>& arguments, const std::string& redirection) {
  const ScratchFolder folder;
  std::string command = "exec " + test::emulator() + " " PIXELSCOPE_BIN_DIR "/pixelscope-cli";
  for (const std::string& argument : arguments) command += " " + shell_quote(argument);
  const int status = std::system((command + " 2>" + shell_quote(folder.file("err")) + " " + redirection).c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), read_whole_file(folder.file("err"))};
}

TEST(StandardOutput, AFullDiskIsAFailure) {
  for (std::size_t i = 0; i < printing_commands().size(); i += test::list_step) {
    const auto& command = printing_commands()[i];
    const auto [status, message] = run_by_shell(command, ">/dev/full");
    EXPECT_EQ(status, 2) << command.front();
    EXPECT_TRUE(message.starts_with("pixelscope-cli: standard output cannot be written")) << message;
    if (command.front().front() != '-') {  // of the other two the parser empties the buffer, and the reason is lost
      EXPECT_NE(message.find("No space left on device"), std::string::npos) << command.front();
    }
  }
}

TEST(StandardOutput, AClosedOneIsAFailure) {
  for (std::size_t i = 0; i < printing_commands().size(); i += test::list_step) {
    const auto& command = printing_commands()[i];
    const auto [status, message] = run_by_shell(command, ">&-");
    EXPECT_EQ(status, 2) << command.front();
    EXPECT_NE(message.find("standard output cannot be written"), std::string::npos) << message;
  }
}

TEST(StandardOutput, AClosedOneIsNotTakenForTheNextFile) {
  const ScratchFolder folder;
  const auto [status, message] =
      run_by_shell({"stability", "epsilon-unit", "--effort", "0.01", "--out", folder.path().string()}, ">&-");
  EXPECT_EQ(status, 2) << message;
  std::istringstream log(read_whole_file(folder.file("runs.jsonl")));  // open while the results are printed
  for (std::string line; std::getline(log, line);) EXPECT_EQ(line.substr(0, 1), "{") << line;
}

TEST(StandardOutput, NothingToPrintNeedsNone) {
  const ScratchFolder folder;
  const auto [status, message] =
      run_by_shell({"render", "cgfs/lens", "--size", "9x9", "--out", folder.file("a.png")}, ">&- <&-");
  EXPECT_EQ(status, 0) << message;
}

TEST(StandardOutput, AReaderThatHasGone) {
  int ends[2] = {-1, -1};
  ASSERT_EQ(pipe(ends), 0);
  close(ends[0]);
  const std::string redirection = ">&" + std::to_string(ends[1]);
  const auto run = [&](void (*pipe_signal)(int)) {
    const auto before = std::signal(SIGPIPE, pipe_signal);
    auto result = run_by_shell({"options", "--json"}, redirection);
    std::signal(SIGPIPE, before);
    return result;
  };
  const auto [by_signal, silence] = run(SIG_DFL);
  EXPECT_EQ(by_signal, 128 + SIGPIPE) << "as every program that `head` has read enough of";
  EXPECT_EQ(silence, "");
  const auto [status, message] = run(SIG_IGN);
  EXPECT_EQ(status, 2) << "where the caller has switched the signal off";
  EXPECT_EQ(message, "pixelscope-cli: standard output cannot be written (Broken pipe)\n");
  close(ends[1]);
}

}  // namespace
}  // namespace ps::standard_output_test
