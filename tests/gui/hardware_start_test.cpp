// The hardware renderer's context is made when a picture or the list of renderers asks for it, not at every start.
#include <gtest/gtest.h>

#include <sstream>

#include "gui/program.h"
#include "gui/remembering_window.h"
#include "support/golden.h"

namespace ps::gui::hardware_start_test {
namespace {

TEST(HardwareStart, NoContextBeforeSomethingAsksForIt) {
  if (!test::have_xdotool()) GTEST_SKIP() << "xdotool is not installed";
  const auto folder = std::filesystem::absolute(fresh_output_folder("gui-hardware-start"));
  // A context without a window comes from EGL, which nothing else in the program loads.
  const std::string look = "maps=/proc/$(xdotool getwindowpid $window)/maps\n", out = (folder / "counted").string(),
                    count = "grep -c libEGL $maps >>" + out + " || true\n";
  const auto result =
      test::play_by_hand("wait idle\nprint window/size\nwait 1500\nset renderer=hardware\nwait idle\nwait 1500\nquit\n",
                         look + count + "sleep 2\n" + count, folder, "cgfs/spheres --size 64x64");
  ASSERT_EQ(result.status, 0) << result.errors;
  std::istringstream counts(test::read_file(out));
  int before = -1, after = -1;
  counts >> before >> after;
  EXPECT_EQ(before, 0);
  EXPECT_GT(after, 0);
}

}  // namespace
}  // namespace ps::gui::hardware_start_test
