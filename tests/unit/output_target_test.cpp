// Where output may go: files are replaced as a whole, everything else that has a name is written into and stays.
#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <optional>
#include <thread>

#include "base/atomic_file.h"
#include "base/check.h"
#include "base/output_target.h"
#include "support/refusal.h"
#include "support/run_cli.h"

namespace ps::output_target_test {
namespace {

namespace fs = std::filesystem;
using test::run_cli;
using test::run_cli_well;
using test::ScratchFolder;

constexpr unsigned null_device = 3, full_device = 7;  // minor numbers of the memory devices, whose major is 1

/// For the superuser a device of our own, so that a wrong program cannot delete the machine's: nothing where the system
/// allows none. Other users get a link to the machine's, which they cannot delete.
std::optional<std::string> own_device(const ScratchFolder& folder, const std::string& name, unsigned minor_number) {
  const std::string path = folder.file(name);
  if (geteuid() != 0) {
    fs::create_symlink(minor_number == null_device ? "/dev/null" : "/dev/full", path);
    return path;
  }
  if (mknod(path.c_str(), S_IFCHR | 0666, makedev(1, minor_number)) != 0) return {};
  const int file = open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (file < 0) return {};
  close(file);
  return path;
}

bool is_device(const std::string& path) { return fs::is_character_file(fs::status(path)); }

std::string writing_error(const fs::path& path, std::string_view bytes = "new") {
  return test::refusal_of([&] { write_file_atomically(path, bytes); });
}

/// What a program that reads a pipe gets, until all writers have gone.
class PipeReader {
 public:
  explicit PipeReader(const std::string& path) : reader_([this, path] { text_ = all_of(path); }) {}
  std::string text() {
    reader_.join();
    return text_;
  }

 private:
  static std::string all_of(const std::string& path) {
    const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
    std::string text;
    std::array<char, 4096> part{};
    for (ssize_t got = 0; (got = read(file, part.data(), part.size())) > 0;)
      text.append(part.data(), static_cast<std::size_t>(got));
    close(file);
    return text;
  }
  std::string text_;
  std::thread reader_;
};

TEST(OutputTarget, DevicesStay) {
  const ScratchFolder folder;
  const auto null = own_device(folder, "null", null_device), full = own_device(folder, "full", full_device);
  if (!null || !full) GTEST_SKIP() << "no devices may be made here";
  EXPECT_EQ(writing_error(*null), "");
  EXPECT_TRUE(is_device(*null));
  EXPECT_NE(writing_error(*full).find("No space left on device"), std::string::npos);
  EXPECT_TRUE(is_device(*full));
  fs::create_symlink("null", folder.file("link"));
  EXPECT_EQ(writing_error(folder.file("link")), "");
  EXPECT_TRUE(is_device(*null));
  EXPECT_TRUE(fs::is_symlink(folder.file("link")));
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"full", "link", "null"}));
}

TEST(OutputTarget, EveryCommandLeavesDevicesInPlace) {
  const ScratchFolder folder;
  const auto null = own_device(folder, "null.png", null_device), full = own_device(folder, "full.png", full_device);
  if (!null || !full) GTEST_SKIP() << "no devices may be made here";
  const std::string picture = folder.file("a.png");
  const std::vector<std::string> scene{"cgfs/lens", "--size", "9x9"};
  const auto with_scene = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin() + 1, scene.begin(), scene.end());
    return arguments;
  };
  const auto commands = [&](const std::string& target) {
    return std::vector<std::vector<std::string>>{with_scene({"render", "--out", target}),
                                                 with_scene({"render", "--out", picture, "--stats", target}),
                                                 with_scene({"inspect", "--pixel", "3,3", "--out", target}),
                                                 {"compare", picture, picture, "--diff", target},
                                                 with_scene({"precision", "--out", target})};
  };
  ASSERT_EQ(run_cli(with_scene({"render", "--out", picture})).status, 0);
  for (const auto& command : commands(*null)) EXPECT_EQ(run_cli(command).status, 0) << command.front();
  for (const auto& command : commands(*full)) {
    const auto result = run_cli(command);
    EXPECT_EQ(result.status, 2) << command.front();
    EXPECT_NE(result.err.find("full.png: could not be written to the end"), std::string::npos) << result.err;
  }
  EXPECT_TRUE(is_device(*null));
  EXPECT_TRUE(is_device(*full));
}

TEST(OutputTarget, PipesAreWrittenInto) {
  const ScratchFolder folder;
  const std::string pipe = folder.file("pipe");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const std::string bytes(300'000, 'x');  // more than a pipe holds
  PipeReader reader(pipe);
  EXPECT_EQ(writing_error(pipe, bytes), "");
  EXPECT_EQ(reader.text(), bytes);
  EXPECT_TRUE(fs::is_fifo(pipe));
  EXPECT_EQ(folder.names(), std::vector<std::string>{"pipe"});
}

TEST(OutputTarget, AReaderThatGoesAwayIsAnError) {
  const ScratchFolder folder;
  const std::string pipe = folder.file("pipe");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const int reader = open(pipe.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  std::thread leaving([&] {
    char one = 0;
    while (read(reader, &one, 1) < 1) std::this_thread::yield();
    close(reader);
  });
  EXPECT_NE(writing_error(pipe, std::string(300'000, 'x')).find("Broken pipe"), std::string::npos);
  leaving.join();
}

TEST(OutputTarget, StandardOutputByItsName) {
  const auto printed = run_cli({"inspect", "cgfs/lens", "--size", "9x9", "--pixel", "3,3", "--json"});
  const auto named =
      run_cli_well({"inspect", "cgfs/lens", "--size", "9x9", "--pixel", "3,3", "--json", "--out", "/dev/stdout"});
  EXPECT_FALSE(named.out.empty());
  EXPECT_EQ(named.out, printed.out) << "run_cli() gives the program a regular file, which must not be replaced";
}

TEST(OutputTarget, LinksLeadToFiles) {
  const ScratchFolder folder;
  fs::create_directory(folder.file("below"));
  fs::create_symlink("below/file", folder.file("first"));
  fs::create_symlink("first", folder.file("second"));
  EXPECT_EQ(writing_error(folder.file("second"), "made"), "") << "the last link leads to a name that is free";
  EXPECT_EQ(read_whole_file(folder.file("below/file")), "made");
  EXPECT_EQ(writing_error(folder.file("second"), "replaced"), "");
  EXPECT_EQ(read_whole_file(folder.file("below/file")), "replaced");
  EXPECT_TRUE(fs::is_symlink(folder.file("first")));
  EXPECT_TRUE(fs::is_symlink(folder.file("second")));
  fs::create_symlink("circle", folder.file("circle"));
  EXPECT_NE(writing_error(folder.file("circle")).find("circle"), std::string::npos);
  fs::create_symlink("gone/file", folder.file("lost"));
  EXPECT_NE(writing_error(folder.file("lost")).find("does not exist"), std::string::npos);
}

TEST(OutputTarget, AWriteProtectedFileIsRefused) {
  const ScratchFolder folder;
  const std::string file = folder.write("kept.png", "old");
  fs::permissions(file, fs::perms::owner_read);
  const auto result = run_cli({"render", "cgfs/lens", "--size", "9x9", "--out", file});
  EXPECT_EQ(result.status, 2);
  EXPECT_NE(result.err.find("write-protected"), std::string::npos) << result.err;
  EXPECT_EQ(read_whole_file(file), "old");
}

TEST(OutputTarget, AFolderThatCannotBeWrittenIsRefusedBeforeTheWork) {
  if (geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
  const ScratchFolder folder;
  fs::create_directory(folder.file("closed"));
  fs::permissions(folder.file("closed"), fs::perms::owner_read | fs::perms::owner_exec);
  EXPECT_THROW(output_target(folder.file("closed/a.png")), InputError);
}

TEST(OutputTarget, PermissionsAreKeptAndOtherHardLinksKeepTheOldContent) {
  const ScratchFolder folder;
  const std::string file = folder.write("file", "old");
  fs::create_hard_link(file, folder.file("backup"));
  fs::permissions(file, static_cast<fs::perms>(0666));
  const mode_t before = umask(077);
  EXPECT_EQ(writing_error(file, "new"), "");
  umask(before);
  EXPECT_EQ(fs::status(file).permissions(), static_cast<fs::perms>(0666));
  EXPECT_EQ(read_whole_file(file), "new");
  EXPECT_EQ(read_whole_file(folder.file("backup")), "old");
}

TEST(OutputTarget, OwnerAndGroupAreKept) {
  if (geteuid() != 0) GTEST_SKIP() << "only root may give files away";
  const ScratchFolder folder;
  const std::string file = folder.write("file", "old");
  ASSERT_EQ(chown(file.c_str(), 12, 34), 0);
  EXPECT_EQ(writing_error(file, "new"), "");
  struct stat found {};
  ASSERT_EQ(stat(file.c_str(), &found), 0);
  EXPECT_EQ(found.st_uid, 12u);
  EXPECT_EQ(found.st_gid, 34u);
}

TEST(OutputTarget, NamesAsLongAsTheSystemAllows) {
  const ScratchFolder folder;
  const std::string name = std::string(250, 'n') + ".png";
  EXPECT_EQ(writing_error(folder.file(name)), "");
  EXPECT_EQ(writing_error(folder.file(name), "again"), "");
  EXPECT_EQ(read_whole_file(folder.file(name)), "again");
  EXPECT_EQ(folder.names(), std::vector<std::string>{name});
}

TEST(OutputTarget, AnOutputNeverReplacesWhatTheSceneWasReadFrom) {
  const ScratchFolder folder;
  fs::create_directory(folder.file("textures"));
  const std::string texture = folder.file("textures/die.png");
  ASSERT_EQ(run_cli({"render", "cgfs/lens", "--size", "8x8", "--out", texture}).status, 0);
  folder.write("die.mtl", "newmtl side\nmap_Kd textures/die.png\n");
  folder.write("die.obj",
               "mtllib die.mtl\nusemtl side\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n");
  folder.write("part.scene", "light { type = ambient intensity = 1 }\n");
  const std::string scene = folder.write(
      "die.scene",
      "include = part.scene\nmodel { name = die file = \"die.obj\" }\ninstance { model = die position = (0,0,3) }\n");
  const std::string before = read_whole_file(texture);
  const auto refused = [&](const std::vector<std::string>& arguments, const std::string& file) {
    const std::string old = read_whole_file(file);
    const auto result = run_cli(arguments);
    EXPECT_EQ(result.status, 2) << file;
    EXPECT_NE(result.err.find("is an input of this run"), std::string::npos) << result.err;
    EXPECT_EQ(read_whole_file(file), old);
  };
  fs::create_symlink("textures", folder.file("way"));
  refused({"render", scene, "--size", "8x8", "--out", folder.file("way/die.png")}, texture);
  for (const char* input : {"die.scene", "part.scene", "die.obj", "die.mtl"}) {
    refused({"render", scene, "--size", "8x8", "--out", folder.file("a.png"), "--stats", folder.file(input)},
            folder.file(input));
    refused({"inspect", scene, "--size", "8x8", "--pixel", "1,1", "--out", folder.file(input)}, folder.file(input));
  }
  refused({"precision", scene, "--size", "8x8", "--out", texture}, texture);
  refused({"compare", texture, texture, "--diff", texture}, texture);
  fs::rename(texture, folder.file("textures/picture-0.png"));
  const std::string other = folder.write(
      "textures/other.scene",
      "texture { name = t file = \"picture-0.png\" }\nsphere { center = (0,0,3) radius = 1 texture = t }\n");
  refused({"chart", other, "--size", "8x8", "--out", folder.file("textures")}, folder.file("textures/picture-0.png"));
  fs::rename(folder.file("textures/picture-0.png"), texture);
  const auto twice = run_cli(
      {"render", scene, "--size", "8x8", "--out", folder.file("a.png"), "--stats", folder.file("way/../a.png")});
  EXPECT_EQ(twice.status, 2) << "one file for the picture and its statistics";
  fs::create_hard_link(texture, folder.file("copy.png"));
  EXPECT_EQ(run_cli({"render", scene, "--size", "8x8", "--out", folder.file("copy.png")}).status, 0);
  EXPECT_EQ(read_whole_file(texture), before);
}

}  // namespace
}  // namespace ps::output_target_test
