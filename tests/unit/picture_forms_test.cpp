// What `render` writes besides PNG: levels as text, channels as numbers, and the pattern that tests a display.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>

#include "base/atomic_file.h"
#include "frame/display_frame.h"
#include "image/file.h"
#include "options/scene_settings.h"
#include "render/render.h"
#include "scene/load.h"
#include "support/run_cli.h"

namespace ps::picture_forms_test {
namespace {

using test::run_cli;
using test::run_cli_well;
using test::ScratchFolder;

/// The numbers of an ASCII PPM file behind its magic number, comments left out.
std::vector<int> ppm_numbers(const std::string& file) {
  std::istringstream text(file.substr(file.find('\n')));
  std::vector<int> numbers;
  for (std::string line; std::getline(text, line);) {
    std::istringstream words(line.substr(0, line.find('#')));
    for (int number = 0; words >> number;) numbers.push_back(number);
  }
  return numbers;
}

TEST(PictureForms, AsciiPpmHoldsTheLevels) {
  const ScratchFolder folder;
  const std::string png = folder.file("a.png"), ascii = folder.file("a.ppm"), binary = folder.file("b.ppm");
  const auto render = [](const std::string& out, std::vector<std::string> more) {
    std::vector<std::string> arguments{"render", "cgfs/lens", "--size", "7x5", "--out", out};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_cli(arguments);
  };
  ASSERT_EQ(render(png, {}).status, 0);
  ASSERT_EQ(render(ascii, {"--ppm", "ascii"}).status, 0);
  ASSERT_EQ(render(binary, {"--ppm", "binary"}).status, 0);
  const Image<Rgb8> levels = load_levels(png);
  std::vector<int> wanted{7, 5, 255};
  for (const Rgb8 pixel : levels.pixels()) wanted.insert(wanted.end(), {pixel.r, pixel.g, pixel.b});
  const std::string text = read_whole_file(ascii);
  EXPECT_EQ(text.substr(0, 3), "P3\n");
  EXPECT_EQ(ppm_numbers(text), wanted);
  EXPECT_EQ(read_whole_file(binary).substr(0, 3), "P6\n");
  EXPECT_EQ(load_levels(binary), levels);
  for (const std::vector<std::string>& wrong : std::vector<std::vector<std::string>>{{"--ppm", "text"}, {"--ppm", ""}})
    EXPECT_EQ(render(ascii, wrong).status, 2);
  EXPECT_EQ(render(png, {"--ppm", "ascii"}).status, 2) << "no PPM file";
}

/// A wall at z = 5 in the lower left quarter of the picture, its texture coordinates from 0 to 1, and elsewhere
/// nothing.
constexpr const char* wall_scene = R"(canvas_size = 8 x 8
viewport_size = 1 x 1
projection_plane_d = 1
texture { name = squares generator = checker size = 8 }
rectangle { name = wall corner = (-2.5, -2.5, 5) side_a = (2.5, 0, 0) side_b = (0, 2.5, 0) color = white texture = squares }
light { type = ambient intensity = 1 }
)";

TEST(PictureForms, ChannelsArePfmNumbers) {
  const ScratchFolder folder;
  const std::string scene = folder.write("wall.scene", wall_scene), out = folder.file("channel.pfm");
  for (const char* renderer : {"renderer=ray-tracer", "renderer=rasterizer"}) {
    const auto channel = [&](const std::string& show, const std::string& magic) {
      run_cli_well({"render", scene, "--set", renderer, "--show", show, "--out", out});
      EXPECT_EQ(read_whole_file(out).substr(0, 3), magic + "\n") << show;
      return load_image(out);
    };
    const auto depth = channel("depth", "Pf"), object = channel("object", "Pf"), hit = channel("hit", "Pf");
    const auto normal = channel("normal", "PF"), uv = channel("uv", "PF"), nan = channel("nan", "Pf");
    for (int y = 0; y < 8; ++y)
      for (int x = 0; x < 8; ++x) {
        const bool seen = x < 4 && y >= 4;
        if (seen) {
          EXPECT_NEAR(depth.at(x, y).x, 5, 1e-5);
          EXPECT_NEAR(uv.at(x, y).x, (x + 0.5) / 4, 1e-5);
          EXPECT_NEAR(std::abs(normal.at(x, y).z), 1, 1e-6);
        } else {
          EXPECT_TRUE(std::isinf(depth.at(x, y).x));
        }
        EXPECT_EQ(object.at(x, y).x, seen ? 0.0F : -1.0F);
        EXPECT_EQ(hit.at(x, y).x, seen ? 1.0F : 0.0F);
        EXPECT_EQ(nan.at(x, y).x, 0.0F);
      }
  }
  for (const char* show : {"colour", "barycentric", "triangle", "facing", "overdraw", "tests", "mip", "samples",
                           "shadow", "direction", "shadow-map", "stencil", "environment", "precision", "depth-gap"}) {
    ASSERT_EQ(run_cli({"render", scene, "--show", show, "--out", out}).status, 0) << show;
    EXPECT_EQ(load_image(out).width(), 8) << show;
  }
}

/// CGPP 15.3.2 in closed form: what each quarter of the pattern must be.
TEST(TestPattern, IsThatOfTheBook) {
  const Scene scene = load_scene("cgpp/test-pattern");
  Settings settings = settings_for(scene);
  const View view{scene.camera, 400, 400};
  const Frame frame = render(scene, view, settings);
  const auto levels = display_frame(frame, settings);
  for (int y = 0; y < 200; ++y) {
    const double share = (199 - y) / 199.0;
    for (int x = 0; x < 200; ++x) {
      const Rgb8 pixel = levels.at(x, y);
      if ((x + y) % 2 == 0)
        ASSERT_NEAR(pixel.g, 255 * std::sqrt(share), 0.51) << x << "," << y;
      else
        ASSERT_TRUE(pixel == (Rgb8{0, 0, 25})) << "a tenth of the range under gamma 2";
      ASSERT_NEAR(levels.at(x, y + 200).g, 255 * share, 0.51) << "equal steps in level";
      ASSERT_NEAR(levels.at(x + 200, y + 200).g, 255 * std::sqrt(share), 0.51) << "equal steps in radiance";
    }
  }
  // Of each 8 x 8 pixels of black and white as much light comes as of the gradient beside them.
  for (int y = 0; y < 200; y += 8)
    for (const int x : {56, 64, 72, 80, 88, 152, 160, 168, 176, 184}) {
      double dithered = 0, gradient = 0;
      for (int i = 0; i < 8; ++i)
        for (int k = 0; k < 8; ++k) {
          const float pixel = frame.colour.at(200 + x + i, y + k).g;
          ASSERT_TRUE(pixel == 0 || pixel == 1);
          dithered += pixel / 64;
          gradient += frame.colour.at(200 + x + i - 50, y + k).g / 64;
        }
      EXPECT_NEAR(dithered, gradient, 1.0 / 64 + 8.0 / 199 / 2) << x << "," << y;
    }
  settings.gamma = 1;
  EXPECT_LE(display_frame(frame, settings).at(1, 0).b, 3) << "without gamma correction the blue looks black";
}

}  // namespace
}  // namespace ps::picture_forms_test
