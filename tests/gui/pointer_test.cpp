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

/// Plays `script` in the real window. Its first line of output tells a place in the window; there `hand`, a piece of
/// shell script, uses the real pointer.
void use_pointer(const std::filesystem::path& folder, const std::string& arguments, const std::string& script,
                 const std::string& hand_script) {
  std::ofstream(folder / "pointer.script") << script;
  std::ofstream(folder / "click.sh") << "set -e\n"
                                        "for i in $(seq 200); do read -r place < "
                                     << (folder / "place").string()
                                     << " 2>/dev/null && break; sleep 0.05; done\n"
                                        "window=$(xdotool search --name '^Pixelscope' | head -1)\n"
                                        "xdotool windowfocus $window || true\n"
                                        "xdotool mousemove --window $window ${place%,*} ${place#*,}\n"
                                        "sleep 0.2\n"
                                     << hand_script;
  const std::string clicker =
      "bash " + (folder / "click.sh").string() + " >" + (folder / "clicker.log").string() + " 2>&1";
  std::thread hand([&] { EXPECT_EQ(std::system(clicker.c_str()), 0); });
  const std::string command = "timeout 60 " PIXELSCOPE_BIN_DIR "/pixelscope " + arguments + " --script " +
                              (folder / "pointer.script").string() + " >" + (folder / "place").string() + " 2>" +
                              (folder / "errors").string();
  const int ended = std::system(command.c_str());
  hand.join();
  EXPECT_EQ(ended, 0) << ps::test::read_file(folder / "errors") << ps::test::read_file(folder / "clicker.log");
}

TEST(Pointer, RealPointerAndKeysWork) {
  if (!have_xdotool()) GTEST_SKIP() << "xdotool is not installed";
  const auto folder = std::filesystem::absolute(ps::fresh_output_folder("gui-pointer"));
  use_pointer(
      folder, "--widget-gallery",
      "wait idle\nprint gallery/plain@middle\nwait until gallery/count = 2\n"
      "wait until gallery/held on\nwait until gallery/held off\nexpect gallery/count 2\n",
      "xdotool click 1; sleep 0.2; xdotool click 1; sleep 0.2; xdotool keydown f; sleep 0.3; xdotool keyup f\n");
}

TEST(Pointer, RealPointerPicksAPixelInB) {
  if (!have_xdotool()) GTEST_SKIP() << "xdotool is not installed";
  const auto folder = std::filesystem::absolute(ps::fresh_output_folder("gui-pointer-pixel"));
  // The middle of the view of a picture with an odd number of columns and rows is its middle pixel.
  use_pointer(folder, "cgfs/reflections --size 101x101",
              "wait idle\nexpect-not pixel 50,50\nprint view/b/picture@middle\nwait until pixel 50,50\nwait idle\n"
              "expect b/events > 0\nexpect-not b/verdict \"\"\n",
              "xdotool click 1\n");
}

}  // namespace
