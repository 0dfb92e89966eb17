// The real pointer, moved by xdotool through the X server, must do what pushed events do: Dear ImGui 1.86 treats the
// two differently.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <sys/wait.h>
#include <thread>

#include "gui/program.h"
#include "support/golden.h"

namespace {

bool have_xdotool() { return std::system("command -v xdotool >/dev/null 2>&1") == 0; }

TEST(Pointer, RealPointerAndKeysWork) {
  if (!have_xdotool()) GTEST_SKIP() << "xdotool is not installed";
  const auto folder = std::filesystem::absolute(ps::fresh_output_folder("gui-pointer"));
  // The script tells where the button is; a second program clicks there for real and creates a file that ends the wait.
  std::ofstream(folder / "pointer.script") << "wait idle\n"
                                              "print gallery/plain@middle\n"
                                              "wait until gallery/count = 2\n"
                                              "wait until gallery/held on\n"
                                              "wait until gallery/held off\n"
                                              "screenshot "
                                           << (folder / "after.png").string()
                                           << "\n"
                                              "expect gallery/count 2\n";
  std::ofstream(folder / "click.sh") << "set -e\n"
                                        "for i in $(seq 200); do read -r place < "
                                     << (folder / "place").string()
                                     << " 2>/dev/null && break; sleep 0.05; done\n"
                                        "window=$(xdotool search --name '^Pixelscope' | head -1)\n"
                                        "xdotool windowfocus $window || true\n"
                                        "xdotool mousemove --window $window ${place%,*} ${place#*,}\n"
                                        "sleep 0.2; xdotool click 1; sleep 0.2; xdotool click 1; sleep 0.2\n"
                                        "xdotool keydown f; sleep 0.3; xdotool keyup f\n";
  const std::string clicker =
      "bash " + (folder / "click.sh").string() + " >" + (folder / "clicker.log").string() + " 2>&1";
  std::thread hand([&] { EXPECT_EQ(std::system(clicker.c_str()), 0); });
  const std::string command = "stdbuf -oL timeout 60 " PIXELSCOPE_BIN_DIR "/pixelscope --widget-gallery --script " +
                              (folder / "pointer.script").string() + " >" + (folder / "place").string() + " 2>" +
                              (folder / "errors").string();
  const int ended = std::system(command.c_str());
  hand.join();
  EXPECT_EQ(ended, 0) << ps::test::read_file(folder / "errors") << ps::test::read_file(folder / "clicker.log");
}

}  // namespace
