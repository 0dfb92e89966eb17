// The listing of CGFS ch. 14 with four texels for each pixel, right and with the slip of the author's program, on a
// texture whose colour grows from row to row: there both are a short formula.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "options/option.h"
#include "scene/scene_file.h"
#include "support/render_once.h"

namespace ps::four_texels_test {
namespace {

constexpr int side = 64, texels = 16;
constexpr double step = 1.0 / 32;  // of the colour, from one row to the next; exact in float

/// A wall that fills the canvas at z = 1, so that u and v are columns and rows. It shows what is given for each texel.
Scene wall(double (*colour)(int x, int y)) {
  Scene scene =
      parse_scene("viewport_size = 1 x 1\nprojection_plane_d = 1\nbackground = black\n"
                  "texture { name = picture  generator = checker  size = 16 }\n"
                  "material { name = painted  color = white  texture = picture }\n"
                  "model { name = wall  materials = [painted]\n"
                  "  vertices { 0 = (-0.5, -0.5, 1)  1 = (-0.5, 0.5, 1)  2 = (0.5, 0.5, 1)  3 = (0.5, -0.5, 1) }\n"
                  "  triangles { 0 = { vertices = [0, 1, 2]  uvs = [(0, 1), (0, 0), (1, 0)] }\n"
                  "              1 = { vertices = [0, 2, 3]  uvs = [(0, 1), (1, 0), (1, 1)] } }\n"
                  "}\ninstance { model = wall }\nlight { type = ambient  intensity = 1 }\n",
                  "wall.scene", ".");
  Image<Vec3f> grey(texels, texels, Vec3f(0));
  for (int y = 0; y < texels; ++y)
    for (int x = 0; x < texels; ++x) grey.at(x, y) = Vec3f(static_cast<float>(colour(x, y)));
  std::vector<Texture> textures = *scene.textures;
  textures[0].texels = std::make_shared<const Image<Vec3f>>(std::move(grey));
  scene.textures = Part<std::vector<Texture>>(std::move(textures));
  return scene;
}

double row_by_row(int, int y) { return y * step; }

Image<Vec3d> picture(const char* filter, const char* slips, double (*colour)(int x, int y) = row_by_row) {
  Settings settings;
  for (const std::string& assignment : {std::string("renderer=textbook"), std::string("listing=cgfs-14-textures"),
                                        std::string(filter), std::string(slips)})
    parse_assignment(assignment, settings);
  const Scene scene = wall(colour);
  return render(scene, {scene.camera, side, side}, settings, {}).colour_double;
}

// Between the middles of the first and the last row the colour of four texels is that of the place, v * 16 - 0.5 rows.
// The slip reads T(row + 2) for T(row + 1) in the fourth place, which weighs fu * fv: one step more of it.
TEST(FourTexels, RightAndWithTheSlip) {
  const Image<Vec3d> right = picture("texture-filter=bilinear", "demo-slips=off");
  const Image<Vec3d> slip = picture("texture-filter=bilinear", "demo-slips=on");
  int compared = 0;
  double largest = 0;
  for (int row = 4; row < side - 8; ++row)
    for (int column = 4; column < side - 4; ++column) {
      // The book's pixel (x, y) is the point (x / side, y / side); v grows downwards from y = side / 2.
      const double u = static_cast<double>(column) / side, v = static_cast<double>(row + 1) / side;
      const double x = u * texels - 0.5, y = v * texels - 0.5;
      const double fu = x - std::floor(x), fv = y - std::floor(y);
      EXPECT_NEAR(right.at(column, row).x, y * step, 1e-6) << column << ", " << row;
      EXPECT_NEAR(slip.at(column, row).x, (y + fu * fv) * step, 1e-6) << column << ", " << row;
      largest = std::max(largest, fu * fv);
      ++compared;
    }
  EXPECT_GT(compared, 2000);
  EXPECT_GT(largest, 0.3) << "the slip must be seen";
}

// The program's own texture is a checkerboard. There the wrong texel has the colour of the right one.
TEST(FourTexels, ACheckerboardHidesTheSlip) {
  const auto checks = [](int x, int y) { return (x + y) % 2 == 0 ? 1.0 : 0.25; };
  const Image<Vec3d> right = picture("texture-filter=bilinear", "demo-slips=off", checks);
  const Image<Vec3d> slip = picture("texture-filter=bilinear", "demo-slips=on", checks);
  for (int row = 4; row < side - 8; ++row)
    for (int column = 4; column < side - 4; ++column) ASSERT_EQ(slip.at(column, row), right.at(column, row));
}

TEST(FourTexels, WithoutTheFilterTheNearestOneCounts) {
  const Image<Vec3d> nearest = picture("texture-filter=trilinear", "demo-slips=off");
  for (int row = 4; row < side - 8; ++row) {
    const double v = static_cast<double>(row + 1) / side;
    EXPECT_NEAR(nearest.at(20, row).x, std::floor(v * texels) * step, 1e-6) << row;
  }
}

}  // namespace
}  // namespace ps::four_texels_test
