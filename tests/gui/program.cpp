#include "gui/program.h"

#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

namespace ps::test {

std::string read_file(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

WindowRun run_window(const std::string& arguments, const std::string& before) {
  static int count = 0;
  const auto folder = std::filesystem::temp_directory_path() /
                      ("pixelscope-gui-" + std::to_string(getpid()) + "-" + std::to_string(++count));
  std::filesystem::create_directories(folder);
  const std::string out = folder / "out", err = folder / "err";
  const std::string command =
      before + " " PIXELSCOPE_BIN_DIR "/pixelscope " + arguments + " >" + out + " 2>" + err + " </dev/null";
  const int ended = std::system(command.c_str());
  WindowRun result{WIFEXITED(ended) ? WEXITSTATUS(ended) : -1, read_file(out), read_file(err)};
  std::filesystem::remove_all(folder);
  return result;
}

WindowRun play(const std::string& commands, const std::filesystem::path& folder, const std::string& size,
               const std::string& arguments) {
  const auto script = folder / "script.script";
  std::ofstream(script) << commands;
  return run_window("--window-size " + size + " --script " + script.string() + " " + arguments);
}

}  // namespace ps::test
