#include <gtest/gtest.h>

#include <algorithm>

#include "support/run_cli.h"

namespace ps::cli_bad_input_test {
namespace {

using test::run_cli;
using test::run_cli_well;
using test::ScratchFolder;

constexpr const char* good_scene = "sphere { center = (0, 0, 3) radius = 1 color = (255, 0, 0) }\n";

/// One line is the message; those behind it quote a file, or are about further errors in it.
bool is_one_message(const std::string& text) {
  const std::string first = text.substr(0, text.find('\n') + 1), rest = text.substr(first.size());
  return first.starts_with("pixelscope-cli: ") && rest.find("pixelscope-cli: ") == std::string::npos &&
         (rest.empty() || (rest.starts_with("    ") && rest.ends_with('\n')));
}

/// The program must refuse with status 2 and one message on standard error that holds `message`.
void expect_refused(const std::vector<std::string>& arguments, const std::string& message) {
  const auto result = run_cli(arguments);
  EXPECT_EQ(result.status, 2) << result.out << result.err;
  EXPECT_NE(result.err.find(message), std::string::npos) << result.err;
  EXPECT_TRUE(is_one_message(result.err)) << result.err;
  EXPECT_TRUE(result.out.empty()) << result.out;
}

/// Renders a scene file with this text into the folder: refused, and no picture is left.
void expect_scene_refused(const std::string& text, const std::string& message) {
  const ScratchFolder folder;
  const std::string scene = folder.write("bad.scene", text);
  expect_refused({"render", scene, "--size", "8x8", "--out", folder.file("picture.png")}, message);
  EXPECT_EQ(folder.names(), std::vector<std::string>{"bad.scene"});
}

// A listing has neither samples nor fragments for the microscope to show.
TEST(CliBadInput, MicroscopeOfAListing) {
  expect_refused({"inspect", "cgfs/spheres", "--size", "8x8", "--pixel", "4,4", "--svg", "microscope", "--set",
                  "renderer=textbook"},
                 "found renderer=textbook");
}

TEST(CliBadInput, Scenes) {
  expect_scene_refused("", "bad.scene");
  expect_scene_refused("sphere { centre = (0, 0, 3) radius = 1 }", "bad.scene:1:10");
  expect_scene_refused("sphere { center = radius = 1 }", "bad.scene:1:");
  expect_scene_refused("sphere { center = (0, nan, 3) radius = 1 }", "bad.scene:1:");
  expect_scene_refused("sphere { center = (0, 0, 3) radius = -1 }", "bad.scene:1:");
  expect_scene_refused("sphere { center = (0, 0, 3)", "bad.scene:1:");
  // The line with a caret, and up to five errors at once.
  expect_scene_refused("# mine\nsphere { center = (0, 0, 3) radius = -1 }",
                       ": found '-1', expected a number greater than 0\n"
                       "    sphere { center = (0, 0, 3) radius = -1 }\n"
                       "                                         ^\n");
  expect_scene_refused("sphere { radius = -1 }\nlight { type = sun }\n", "bad.scene:2:16: found 'sun', expected");
  expect_scene_refused("instance { model = nothing position = (0, 0, 0) }", "bad.scene:1:");
}

TEST(CliBadInput, Objects) {
  const ScratchFolder folder;
  const std::string out = folder.file("picture.png");
  const auto refused = [&](const char* name, const char* text) {
    expect_refused({"render", folder.write(name, text), "--size", "8x8", "--out", out}, name);
  };
  refused("empty.obj", "");
  refused("no_faces.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n");
  refused("too_high.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n");
  refused("too_low.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -1 -2 -4\n");
  refused("zero.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n");
  EXPECT_FALSE(std::filesystem::exists(out));
  run_cli_well({"render", folder.write("relative.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\n"), "--size", "8x8",
                "--out", out});
  EXPECT_TRUE(std::filesystem::exists(out));
}

TEST(CliBadInput, RenderArguments) {
  const ScratchFolder folder;
  const std::string scene = folder.write("good.scene", good_scene);
  const std::string out = folder.file("picture.png");
  const auto refused = [&](std::vector<std::string> more, const char* message) {
    std::vector<std::string> arguments{"render", scene, "--out", out};
    arguments.insert(arguments.end(), more.begin(), more.end());
    expect_refused(arguments, message);
  };
  refused({"--size", "0x0"}, "0 x 0");
  refused({"--size", "100000x100000"}, "100000 x 100000");
  refused({"--size", "10"}, "WIDTHxHEIGHT");
  refused({"--set", "reflection-dept=1"}, "did you mean 'reflection-depth'");
  refused({"--set", "reflection-depth=65"}, "reflection-depth");
  refused({"--set", "shadow-epsilon=nan"}, "shadow-epsilon");
  refused({"--set", "renderer"}, "KEY=VALUE");
  refused({"--show", "nothing"}, "nothing");
  refused({"--size", "8x8", "--region", "8,0,1,1"}, "--region");
  refused({"--size", "8x8", "--region", "0,0,0,1"}, "--region");
  refused({"--size", "8x8", "--region", "0,0,1"}, "--region");
  refused({"--camera", "1,2,3"}, "camera");
  refused({"--edit", "light"}, "PATH=VALUE");
  refused({"--edit", "light.7.intensity=1"}, "light.7");
  refused({"--frobnicate"}, "--frobnicate");
  refused({"--stats", folder.file("nowhere/stats.json")}, "does not exist");
  EXPECT_EQ(folder.names(), std::vector<std::string>{"good.scene"});
}

TEST(CliBadInput, Files) {
  const ScratchFolder folder;
  const std::string scene = folder.write("good.scene", good_scene);
  expect_refused({"render", folder.file("missing.scene"), "--out", folder.file("a.png")}, "missing.scene");
  expect_refused({"render", "cgfs/nothing", "--out", folder.file("a.png")}, "cgfs/nothing");
  expect_refused({"render", scene, "--out", folder.file("nowhere/a.png")}, "does not exist");
  expect_refused({"render", scene, "--out", folder.file("a.gif")}, ".gif");
  expect_refused({"render", scene}, "--out");
  expect_refused({"precision", scene, "--out", folder.file("a.gif")}, ".gif");
  expect_refused({"precision", scene, "--gap", folder.file("nowhere/a.png")}, "does not exist");
  expect_refused({"stability", "bhv-holes"}, "did you mean 'bvh-holes'?");
  expect_refused({"stability", "bvh-holes", "--strip", folder.file("a.gif")}, ".gif");
  expect_refused({"stability", "bvh-holes", "--out", scene}, "folder");
  expect_refused({"stability", "bvh-holes", "--resume"}, "--out");
  EXPECT_EQ(folder.names(), std::vector<std::string>{"good.scene"});
}

TEST(CliBadInput, Pixels) {
  expect_refused({"inspect", "cgfs/spheres", "--pixel", "600,0"}, "600,0");
  expect_refused({"inspect", "cgfs/spheres", "--pixel", "-1,0"}, "-1,0");
  expect_refused({"inspect", "cgfs/spheres", "--pixel", "left"}, "left");
  expect_refused({"inspect", "cgfs/spheres"}, "--pixel");
}

TEST(CliBadInput, Pictures) {
  const ScratchFolder folder;
  const std::string scene = folder.write("good.scene", good_scene);
  const std::string whole = folder.file("whole.png");
  ASSERT_EQ(run_cli({"render", scene, "--size", "64x64", "--out", whole}).status, 0);
  const std::string bytes = [&] {
    std::string text;
    if (FILE* file = std::fopen(whole.c_str(), "rb")) {
      for (int c = std::fgetc(file); c != EOF; c = std::fgetc(file)) text += static_cast<char>(c);
      std::fclose(file);
    }
    return text;
  }();
  ASSERT_GT(bytes.size(), 100u);
  std::string wrong_sum = bytes;
  wrong_sum[29] = static_cast<char>(wrong_sum[29] ^ 1);  // the CRC of the first chunk
  expect_refused({"compare", whole, folder.write("short.png", bytes.substr(0, bytes.size() / 2))}, "short.png");
  expect_refused({"compare", whole, folder.write("sum.png", wrong_sum)}, "sum.png");
  expect_refused({"compare", whole, folder.write("empty.png", "")}, "empty.png");
  expect_refused({"compare", whole, folder.file("missing.png")}, "missing.png");
  const std::string small = folder.file("small.png");
  ASSERT_EQ(run_cli({"render", scene, "--size", "8x8", "--out", small}).status, 0);
  expect_refused({"compare", whole, small}, "8");
}

TEST(CliBadInput, Commands) {
  expect_refused({}, "subcommand");
  expect_refused({"frobnicate"}, "frobnicate");
  expect_refused({"options", "--xml"}, "--xml");
  expect_refused({"lessons", "show", "nothing"}, "unknown lesson 'nothing'");
  expect_refused({"lessons", "check", "nothing"}, "unknown lesson 'nothing'");
}

}  // namespace
}  // namespace ps::cli_bad_input_test
