// A machine without OpenGL has the same window: its libraries are hidden from the program.
#include <gtest/gtest.h>

#include <filesystem>

#include "gui/program.h"
#include "image/difference.h"
#include "image/file.h"
#include "support/environment.h"
#include "support/golden.h"
#include "support/run_cli.h"

namespace without_opengl_test {
namespace {

using namespace ps;

struct Played {
  Image<Rgb8> window, closer;
  std::string output;
};

Played play(const std::string& name) {
  const auto folder = std::filesystem::absolute(fresh_output_folder("gui-without-opengl-" + name));
  const std::string window = (folder / "window.png").string(), closer = (folder / "closer.png").string();
  const std::string commands = "wait idle\nscreenshot " + window +
                               "\nprint view/a/title\nclick-pixel A 100,100\nset shading=flat\nwait idle\nscreenshot " +
                               closer + "\nclick menu/help\nclick about\nwait idle\nprint about/Graphics\nquit\n";
  const auto result = test::play(commands, folder, "1024x768", "cgfs/shading --size 200x200");
  EXPECT_EQ(result.status, 0) << result.errors;
  return {load_levels(window), load_levels(closer), result.output};
}

/// Per thousand of the pixels that differ by more than text and lines do whose edges are smoothed a little otherwise.
double per_mille_apart(const Image<Rgb8>& a, const Image<Rgb8>& b) {
  constexpr int smoothing = 64;
  long apart = 0;
  for (std::size_t i = 0; i < a.pixels().size(); ++i)
    apart += largest_difference(a.pixels()[i], b.pixels()[i]) > smoothing;
  return 1000.0 * static_cast<double>(apart) / static_cast<double>(a.pixels().size());
}

TEST(WithoutOpenGl, TheWindowIsTheSame) {
  const Played with = play("with");
  const test::ScratchFolder folder;
  for (const char* library : {"libGL.so.1", "libEGL.so.1", "libGLESv2.so.2"}) folder.write(library, "");  // found first
  const test::FirstLibraryFolder hidden(folder.path().string());
  const Played without = play("without");
  EXPECT_EQ(with.output.find("no OpenGL"), std::string::npos) << with.output;
  EXPECT_NE(without.output.find("no OpenGL"), std::string::npos) << without.output;
  for (const auto& [one, other] : {std::pair{&with.window, &without.window}, {&with.closer, &without.closer}}) {
    ASSERT_EQ(one->width(), other->width());
    ASSERT_EQ(one->height(), other->height());
    EXPECT_LE(per_mille_apart(*one, *other), 5);
  }
  EXPECT_GT(per_mille_apart(with.window, with.closer), 20);  // what a difference is
}

}  // namespace
}  // namespace without_opengl_test
