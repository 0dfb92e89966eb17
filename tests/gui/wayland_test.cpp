// The window on Wayland, in the compositor weston. Its screen is a window on the display of the tests here, which gives
// it a pointer and a keyboard: its headless back end has none, and the program ends in the window library without them.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "gui/program.h"
#include "image/file.h"
#include "support/golden.h"

namespace wayland_test {
namespace {

bool have(const std::string& program) {
  return std::system(("command -v " + program + " >/dev/null 2>&1").c_str()) == 0;
}

/// Shell commands that start weston with a screen of 1800x1100 units of two pixels, run "$@" in it and end it.
constexpr const char* in_weston = R"(
export XDG_RUNTIME_DIR=$(mktemp -d)
weston --backend=x11-backend.so --use-pixman --no-config --socket=test --width=1800 --height=1100 --scale=2 \
  --idle-time=0 >"$1" 2>&1 &
weston=$!
trap 'kill $weston; wait $weston; rm -rf "$XDG_RUNTIME_DIR"' EXIT
for i in $(seq 200); do [ -S "$XDG_RUNTIME_DIR/test" ] && break; sleep 0.05; done
shift
env -u DISPLAY WAYLAND_DISPLAY=test SDL_VIDEODRIVER=wayland "$@" 2>"$XDG_RUNTIME_DIR/errors"
status=$?
grep -v -e 'plugin directory' -e 'No plugins found' "$XDG_RUNTIME_DIR/errors" >&2  # libdecor's, which draws title bars
exit $status
)";

TEST(Wayland, ScaleTwoFullScreenClipboardAndDrop) {
  if (!have("weston") || !have("xdotool")) GTEST_SKIP() << "weston or xdotool is not installed";
  const auto folder = std::filesystem::absolute(ps::fresh_output_folder("gui-wayland"));
  const std::string run = folder / "in-weston.sh", scene = folder / "dropped.scene";
  std::ofstream(run) << in_weston;
  std::ofstream(scene) << "sphere { center = (0, -1, 3) radius = 1 color = (255, 0, 0) }\n";
  const auto result = ps::test::play_by_hand(
      "wait idle\nkeep window/size NORMAL\nscreenshot " + (folder / "normal.png").string() +
          "\nprint window/size\nwait until window/fullscreen on\nwait until window/size 1800x1100\nwait idle\n"
          "screenshot " +
          (folder / "full.png").string() +
          "\nwait until window/fullscreen off\nwait until window/size $NORMAL\n"
          "wait until clipboard contains scene=\n"
          "drop " +
          scene + "\nwait idle\nexpect scene \"" + scene + "\"\n",
      "xdotool mousemove 900 700\nsleep 0.5\n"
      "xdotool key F11\nsleep 2\nxdotool key F11\nsleep 1\nxdotool key c\n",
      folder, "cgfs/spheres --window-size 900x600", "bash " + run + " " + (folder / "weston.log").string());
  EXPECT_EQ(result.status, 0) << result.errors;
  EXPECT_EQ(result.errors, "");
  const auto size_of = [&](const char* name) { return ps::load_levels(folder / name); };
  EXPECT_EQ(size_of("normal.png").width(), 1800);
  EXPECT_EQ(size_of("normal.png").height(), 1200);
  EXPECT_EQ(size_of("full.png").width(), 3600);
  EXPECT_EQ(size_of("full.png").height(), 2200);
}

}  // namespace
}  // namespace wayland_test
