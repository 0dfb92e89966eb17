// A machine without OpenGL has the same window: its libraries are hidden from the program.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <regex>
#include <string>

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
  int captions_row = 0;  ///< the middle of the lines below the pictures, in pixels from the top
  std::string output;
};

Played play(const std::string& name) {
  const auto folder = std::filesystem::absolute(fresh_output_folder("gui-without-opengl-" + name));
  const std::string window = (folder / "window.png").string(), closer = (folder / "closer.png").string();
  const std::string commands = "wait idle\nscreenshot " + window +
                               "\nprint view/a/title\nclick-pixel A 100,100\nset shading=flat\nwait idle\nscreenshot " +
                               closer +
                               "\nprint view/a/footer@middle\nclick menu\nclick menu/help\nclick about\nwait idle\n"
                               "print about/Graphics\nquit\n";
  const auto result = test::play(commands, folder, "1024x768", "cgfs/shading --size 200x200");
  EXPECT_EQ(result.status, 0) << result.errors;
  std::smatch middle;
  EXPECT_TRUE(std::regex_search(result.output, middle, std::regex("\n[0-9]+,([0-9]+)\n"))) << result.output;
  return {load_levels(window), load_levels(closer), middle.empty() ? 0 : std::stoi(middle[1]), result.output};
}

/// Per thousand of the pixels that differ by more than text and lines do whose edges are smoothed a little otherwise.
/// The lines below the pictures, with times that no two runs share, do not count.
double per_mille_apart(const Image<Rgb8>& a, const Image<Rgb8>& b, int captions_row) {
  constexpr int smoothing = 64, half_of_the_captions = 24;
  long apart = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width() && std::abs(y - captions_row) > half_of_the_captions; ++x)
      apart += largest_difference(a.at(x, y), b.at(x, y)) > smoothing;
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
  EXPECT_EQ(with.captions_row, without.captions_row);
  for (const auto& [one, other] : {std::pair{&with.window, &without.window}, {&with.closer, &without.closer}}) {
    ASSERT_EQ(one->width(), other->width());
    ASSERT_EQ(one->height(), other->height());
    EXPECT_LE(per_mille_apart(*one, *other, with.captions_row), 5);
  }
  EXPECT_GT(per_mille_apart(with.window, with.closer, with.captions_row), 20);  // what a difference is
}

}  // namespace
}  // namespace without_opengl_test
