// Files that no editor writes: each is refused with status 2 and one message on standard error, quickly and without
// much memory; no picture is left behind.
#include <gtest/gtest.h>

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <random>

#include "support/run_cli.h"
#include "support/trials.h"

namespace ps::cli_strange_files_test {
namespace {

namespace fs = std::filesystem;
using test::run_cli;
using test::run_cli_well;
using test::ScratchFolder;

class StrangeFiles : public testing::Test {
 protected:
  void expect_refused(const std::string& name, const std::string& message) {
    const std::string out = folder_.file("picture.png");
    const auto result = run_cli({"render", folder_.file(name), "--size", "8x8", "--out", out});
    EXPECT_EQ(result.status, 2) << name << ": " << result.err;
    EXPECT_NE(result.err.find(message), std::string::npos) << result.err;
    // Behind the line with the message at most the line of the file and a caret.
    const auto lines = std::count(result.err.begin(), result.err.end(), '\n');
    EXPECT_TRUE(lines == 1 || (lines == 3 && result.err.ends_with(" ^\n"))) << result.err;
    EXPECT_LT(result.err.size(), 600U) << "a message, not the file";
    EXPECT_FALSE(fs::exists(out));
  }
  void write_and_expect_refused(const std::string& name, const std::string& text, const std::string& message) {
    folder_.write(name, text);
    expect_refused(name, message);
  }

  ScratchFolder folder_;
};

TEST_F(StrangeFiles, FoldersDevicesPipesAndLinks) {
  for (const std::string extension : {".scene", ".obj"}) {
    fs::create_directory(folder_.file("folder" + extension));
    expect_refused("folder" + extension, "a folder");
    fs::create_symlink("/dev/zero", folder_.file("endless" + extension));
    expect_refused("endless" + extension, "a device");
    ASSERT_EQ(mkfifo(folder_.file("pipe" + extension).c_str(), 0600), 0);
    expect_refused("pipe" + extension, "pipe");
    fs::create_symlink("circle" + extension, folder_.file("circle" + extension));
    expect_refused("circle" + extension, "no such file");
  }
  expect_refused(".", "an unknown kind of file");
}

TEST_F(StrangeFiles, SizesBeyondTheLimits) {
  folder_.write("large.obj", "");
  fs::resize_file(folder_.file("large.obj"), std::uintmax_t{5} << 30);
  expect_refused("large.obj", "5368709120 bytes");
  folder_.write("large.scene", "");
  fs::resize_file(folder_.file("large.scene"), std::uintmax_t{1} << 30);
  expect_refused("large.scene", "bytes");
}

TEST_F(StrangeFiles, WithoutPermission) {
  if (geteuid() == 0) GTEST_SKIP() << "root may read everything";
  for (const std::string name : {"closed.scene", "closed.obj"}) {
    folder_.write(name, "v 0 0 0\n");
    ASSERT_EQ(chmod(folder_.file(name).c_str(), 0), 0);
    expect_refused(name, "permission");
  }
}

TEST_F(StrangeFiles, BinaryRubbish) {
  std::mt19937 random(5);
  std::string bytes;
  for (int i = 0; i < 100000; ++i) bytes += static_cast<char>(random());
  write_and_expect_refused("rubbish.scene", bytes, "rubbish.scene:");
  write_and_expect_refused("rubbish.obj", bytes, "rubbish.obj:");
  write_and_expect_refused("picture.scene", "\x89PNG\r\n\x1a\n", "picture.scene:");
  write_and_expect_refused("wide.obj", std::string("\xFF\xFEv\0 \0", 6), "UTF-16");
  write_and_expect_refused("wide.scene", std::string("\xFF\xFEv\0 \0", 6), "UTF-16");
}

TEST_F(StrangeFiles, DeepAndLong) {
  write_and_expect_refused("brackets.scene", std::string(test::trials(3'000'000), '('), "brackets.scene:1:");
  std::string blocks;
  for (int i = 0; i < test::trials(100'000); ++i) blocks += "difference { ";
  write_and_expect_refused("blocks.scene", blocks, "at most 32 nested brackets");
  std::string many;
  for (int i = 0; i < 100'001; ++i) many += "sphere{center=(0,0,3)radius=1}\n";
  write_and_expect_refused("many.scene", many, "at most 100000 spheres");
  write_and_expect_refused("line.obj", "v 0 0 0 # " + std::string(5'000'000, 'x') + "\n", "at most 4194304 bytes");
}

TEST_F(StrangeFiles, IncludesInCirclesAndChains) {
  folder_.write("b.scene", "include = a.scene\n");
  write_and_expect_refused("a.scene", "include = b.scene\n", "a file that does not include this one");
  // Each file includes the next one twice: 2^30 readings if nothing stops them.
  for (int i = 0; i < 30; ++i) {
    const std::string next = "include = c" + std::to_string(i + 1) + ".scene\n";
    folder_.write("c" + std::to_string(i) + ".scene", next + next);
  }
  folder_.write("c30.scene", "background = red\n");
  expect_refused("c0.scene", "nested files");
}

TEST_F(StrangeFiles, NamesWithControlCharacters) { expect_refused("two\nlines.scene", "no such file"); }

TEST_F(StrangeFiles, WarningsAreShownAndThePictureIsMade) {
  folder_.write("m.obj", "mtllib none.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2\nf 1 2 3\n");
  const auto result =
      run_cli_well({"render", folder_.file("m.obj"), "--size", "8x8", "--out", folder_.file("picture.png")});
  EXPECT_NE(result.err.find("m.obj:1: the material file 'none.mtl' is missing."), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("m.obj:5: lines are not drawn."), std::string::npos) << result.err;
  EXPECT_TRUE(fs::exists(folder_.file("picture.png")));
}

}  // namespace
}  // namespace ps::cli_strange_files_test
