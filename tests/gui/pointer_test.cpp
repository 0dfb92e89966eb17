// The real pointer, moved by xdotool through the X server, must do what pushed events do: Dear ImGui 1.86 treats the
// two differently.
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "gui/program.h"
#include "support/golden.h"

namespace pointer_test {
namespace {

bool have_xdotool() { return std::system("command -v xdotool >/dev/null 2>&1") == 0; }

/// The pointer goes to the place that the script's first line of output gives; there `hand` goes on.
void use_pointer(const std::filesystem::path& folder, const std::string& arguments, const std::string& script,
                 const std::string& hand) {
  const auto result = ps::test::play_by_hand(script,
                                             "xdotool windowfocus $window || true\n"
                                             "xdotool mousemove --window $window ${line%,*} ${line#*,}\n"
                                             "sleep 0.2\n" +
                                                 hand,
                                             folder, arguments);
  EXPECT_EQ(result.status, 0) << result.errors;
  EXPECT_EQ(result.errors, "");
}

TEST(Pointer, RealPointerAndKeysWork) {
  if (!have_xdotool()) GTEST_SKIP() << "xdotool is not installed";
  const auto folder = std::filesystem::absolute(ps::fresh_output_folder("gui-pointer"));
  use_pointer(folder, "--widget-gallery",
              "wait idle\nprint gallery/plain@middle\nwait until gallery/count = 2\n"
              "wait until gallery/held on\nwait until gallery/held off\nexpect gallery/count 2\n",
              "xdotool click 1; sleep 0.5; xdotool click 1; sleep 0.5; xdotool keydown f; sleep 1; xdotool keyup f\n");
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
}  // namespace pointer_test
