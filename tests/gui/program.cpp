#include "gui/program.h"

#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <thread>

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
  setenv("XDG_PICTURES_DIR", folder.c_str(), 1);  // what a key saves does not land among the sources
  const std::string out = folder / "out", err = folder / "err";
  const std::string command =
      before + " " PIXELSCOPE_BIN_DIR "/pixelscope " + arguments + " >" + out + " 2>" + err + " </dev/null";
  const int ended = std::system(command.c_str());
  WindowRun result{WIFEXITED(ended) ? WEXITSTATUS(ended) : -1, read_file(out), read_file(err)};
  std::filesystem::remove_all(folder);
  return result;
}

namespace {

/// A display of its own for a window that is larger than the one of the tests.
std::string display_for(const std::string& size) {
  int width = 0, height = 0;
  char cross = 0;
  std::istringstream(size) >> width >> cross >> height;
  return width > 1920 || height > 1200 ? "app/virtual-display" : "";
}

}  // namespace

WindowRun play(const std::string& commands, const std::filesystem::path& folder, const std::string& size,
               const std::string& arguments) {
  const auto script = folder / "script.script";
  std::ofstream(script) << commands;
  return run_window("--window-size " + size + " --script " + script.string() + " " + arguments, display_for(size));
}

WindowRun play_by_hand(const std::string& commands, const std::string& hand, const std::filesystem::path& folder,
                       const std::string& arguments, const std::string& before) {
  const std::string script = folder / "script.script", out = folder / "output", err = folder / "errors",
                    hand_script = folder / "hand.sh";
  std::ofstream(script) << commands;
  std::filesystem::remove(out);
  std::ofstream(hand_script) << "set -e\n"
                                "for i in $(seq 400); do read -r line 2>/dev/null <"
                             << out
                             << " && break; sleep 0.05; done\n"
                                "window=$(xdotool search --name '^Pixelscope' | head -1)\n"
                             << hand;
  std::string complaint;
  std::thread hands([&] {
    if (hand.empty()) return;
    const std::string log = folder / "hand.log";
    if (std::system(("bash " + hand_script + " >" + log + " 2>&1").c_str()) != 0)
      complaint = "the hand failed: " + read_file(log);
  });
  const int ended = std::system(("timeout 60 " + before + " " PIXELSCOPE_BIN_DIR "/pixelscope " + arguments +
                                 " --script " + script + " >" + out + " 2>" + err + " </dev/null")
                                    .c_str());
  hands.join();
  return {WIFEXITED(ended) ? WEXITSTATUS(ended) : -1, read_file(out), read_file(err) + complaint};
}

}  // namespace ps::test
