// Where there is no OpenGL, the hardware renderer says why and the program goes on. Each case is a program of its own,
// since libraries are looked for once.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "agreement/hardware/hardware_pair.h"
#include "base/read_file.h"
#include "support/emulated.h"
#include "support/environment.h"
#include "support/run_cli.h"

namespace ps {
namespace {

/// Both renderers in programs of their own: one must fail with the reason, the other draw.
void expect_unavailable(const std::string& reason) {
  const test::ScratchFolder folder;
  const std::string picture = folder.file("picture.png");
  const auto drawn_by = [&](const std::string& renderer) {
    return test::run_cli(
        {"render", "cgfs/shading", "--size", "40x30", "--set", "renderer=" + renderer, "--out", picture});
  };
  const test::ProgramResult hardware = drawn_by("hardware");
  EXPECT_EQ(hardware.status, 2) << hardware.err;
  EXPECT_NE(hardware.err.find("pixelscope-cli: " + reason), std::string::npos) << hardware.err;
  EXPECT_FALSE(std::filesystem::exists(picture));
  const test::ProgramResult software = drawn_by("rasterizer");
  EXPECT_EQ(software.status, 0) << software.err;
}

class HardwareAvailability : public testing::Test {
 protected:
  void SetUp() override {
    if (test::is_emulated()) GTEST_SKIP() << "the emulator has no libraries of OpenGL";
    if (!test::hardware_here(reason_)) GTEST_SKIP() << reason_;
  }
  std::string reason_;
};

TEST_F(HardwareAvailability, WithoutLibEgl) {
  const test::ScratchFolder folder;
  folder.write("libEGL.so.1", "");  // found first, and not a library
  const test::FirstLibraryFolder first(folder.path().string());
  expect_unavailable("no OpenGL: the library libEGL is not installed");
}

TEST_F(HardwareAvailability, WithoutADriver) {
  const test::ScratchFolder folder;
  const test::WithoutEglDriver without(folder.path().string());
  expect_unavailable("no OpenGL: no driver");
}

// Mesa needs some hundred megabytes for its compiler. The program without it needs less.
TEST_F(HardwareAvailability, WithoutMemory) {
  for (const char* kilobytes : {"400000", "500000", "600000"}) {
    const test::ScratchFolder folder;
    const std::string command = "ulimit -v " + std::string(kilobytes) +
                                "; " PIXELSCOPE_BIN_DIR
                                "/pixelscope-cli render cgfs/shading --size 40x30 --set renderer=hardware --out " +
                                folder.file("picture.png") + " 2>" + folder.file("err") + " >&2";
    if (std::system(command.c_str()) < 0) GTEST_SKIP() << "no shell";
    const std::string said = read_whole_file(folder.file("err"));
    EXPECT_FALSE(said.ends_with("no OpenGL: no driver\n")) << said;
  }
}

TEST_F(HardwareAvailability, WithOpenGl32) {
  if (!test::drawn_by_llvmpipe()) GTEST_SKIP() << "only Mesa can be asked for an older OpenGL than it has";
  const test::Variable version("MESA_GL_VERSION_OVERRIDE", "3.2");
  expect_unavailable("no OpenGL: the driver does not offer OpenGL 3.3");
}

TEST_F(HardwareAvailability, WithoutADisplay) {
  const test::ScratchFolder folder;
  const test::Variable x11("DISPLAY", ""), wayland("WAYLAND_DISPLAY", "");
  const test::ProgramResult result =
      test::run_cli({"render", "cgfs/shading", "--size", "40x30", "--set", "renderer=hardware", "--out",
                     folder.file("picture.png"), "--stats", folder.file("stats.json")});
  EXPECT_EQ(result.status, 0) << result.err;
}

}  // namespace
}  // namespace ps
