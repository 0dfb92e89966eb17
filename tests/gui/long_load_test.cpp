// A scene that takes long to load: the window stays usable, says what it does, and can be stopped.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "gui/program.h"
#include "support/golden.h"

namespace long_load_test {
namespace {

/// A sheet of `side` x `side` squares in waves, as Wavefront OBJ.
void write_sheet(const std::filesystem::path& path, int side) {
  std::ofstream file(path);
  for (int y = 0; y <= side; ++y)
    for (int x = 0; x <= side; ++x) file << "v " << x << ' ' << y << ' ' << (x * 7 + y * 13) % 5 << '\n';
  for (int y = 0; y < side; ++y)
    for (int x = 1; x <= side; ++x) {
      const int low = y * (side + 1) + x, high = low + side + 1;
      file << "f " << low << ' ' << low + 1 << ' ' << high + 1 << "\nf " << low << ' ' << high + 1 << ' ' << high
           << '\n';
    }
}

/// A scene of many times the same sheet, under names of their own so that each is read anew: reading takes several
/// times as long as the script below needs to stop it, on any machine.
std::filesystem::path write_slow_scene(const std::filesystem::path& folder) {
  write_sheet(folder / "sheet.obj", 700);
  std::ofstream scene(folder / "sheets.scene");
  for (int i = 0; i < 48; ++i) {
    const std::string name = "sheet" + std::to_string(i);
    std::filesystem::create_symlink("sheet.obj", folder / (name + ".obj"));
    scene << "model { name = " << name << " file = " << name << ".obj }\ninstance { model = " << name << " }\n";
  }
  return folder / "sheets.scene";
}

TEST(LongLoad, CanBeCancelled) {
  const auto folder = ps::fresh_output_folder("gui-long-load");
  const auto model = write_slow_scene(folder);
  const auto result = ps::test::play("wait idle\n"
                                     "keep a/picture FIRST\n"
                                     "keep scene SCENE\n"
                                     "drop " +
                                         model.string() +
                                         "\n"
                                         "wait until loading contains sheets.scene\n"
                                         "wait 600\n"  // until the bar comes
                                         "screenshot " +
                                         (folder / "loading.png").string() +
                                         "\n"
                                         "expect scene $SCENE\n"
                                         "click-pixel A 310,400\n"  // the window answers while it loads
                                         "wait until pixel 310,400\n"
                                         "click status/progress/cancel\n"
                                         "wait idle\n"
                                         "expect loading none\n"
                                         "expect scene $SCENE\n"
                                         "expect a/picture $FIRST\n"
                                         "expect messages 0\n"
                                         "quit\n",
                                     folder, "1024x768");
  EXPECT_EQ(result.status, 0) << result.errors;
  std::filesystem::remove(folder / "sheet.obj");
}

// The buttons of a question for a line of the listing are in the line that shows the progress.
TEST(LongLoad, CanBeCancelledWhileALineIsAskedFor) {
  const auto folder = ps::fresh_output_folder("gui-long-load-asked");
  const auto model = write_slow_scene(folder);
  const auto result = ps::test::play("wait idle\nclick question/turn\nwait idle\ndrop " + model.string() +
                                         "\n"
                                         "wait until loading contains sheets.scene\n"
                                         "wait 600\n"  // until the bar comes
                                         "expect listing/lines > 23\n"
                                         "expect window/cut \"\"\n"
                                         "expect window/overlap \"\"\n"
                                         "screenshot " +
                                         (folder / "loading.png").string() +
                                         "\n"
                                         "click listing/line-167/pick\n"
                                         "expect question/answer \"Answer: line 167\"\n"
                                         "expect window/cut \"\"\n"
                                         "click status/progress/cancel\n"
                                         "wait idle\n"
                                         "expect loading none\n"
                                         "expect question/answer \"Answer: line 167\"\n"
                                         "quit\n",
                                     folder, "1024x768", "--scale 1.5 --lesson cgfs_15_shadows_in_the_rasterizer/3");
  EXPECT_EQ(result.status, 0) << result.errors;
  std::filesystem::remove(folder / "sheet.obj");
}

}  // namespace
}  // namespace long_load_test
