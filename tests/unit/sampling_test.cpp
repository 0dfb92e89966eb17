// Several rays for each pixel against closed forms: areas, and larger pictures made smaller.
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <vector>

#include "raytrace/renderer.h"
#include "scene/load.h"
#include "scene/scene_file.h"
#include "support/render_once.h"

namespace ps::sampling_test {
namespace {

Frame traced(const Scene& scene, const Settings& settings, int width, int height, Channel channels = Channel::none,
             std::optional<TileRect> region = {}) {
  Prepared prepared;
  Progress progress;
  return render_traced(scene, View{scene.camera, width, height}, settings, request_for(channels, region), prepared,
                       progress);
}

Settings samples(int count, SamplePattern pattern = SamplePattern::grid) {
  Settings settings;
  settings.samples_per_pixel = count;
  settings.sample_pattern = pattern;
  return settings;
}

/// A white half of the picture: one pixel is one unit wide on the plane z = 1, centred.
constexpr int side = 32;
constexpr double slope = 0.37, height_at_0 = 0.6;
Scene half_plane() {
  return parse_scene("viewport_size = 32 x 32\nprojection_plane_d = 1\nbackground = black\nsettings { near = 0.5 }\n"
                     "triangle { vertices = [(-1000, -369.4, 1), (1000, 370.6, 1), (1000, -9000, 1)] color = white }\n",
                     "half.scene", ".");
}

/// Area of the part of the unit square at (x, y) that lies below the line, by its exact integral.
double coverage(double x, double y) {
  const auto height = [&](double at) { return slope * at + height_at_0 - y; };
  // The integral of clamp(h, 0, 1) dh / slope.
  const auto integral = [](double h) { return h <= 0 ? 0 : h >= 1 ? h - 0.5 : h * h / 2; };
  return (integral(height(x + 1)) - integral(height(x))) / slope;
}

// With n samples on a grid of m x m cells a straight edge crosses fewer than 2 m cells, so a pixel errs by less than
// 2 / m; over many pixels, errors must cancel.
TEST(Sampling, AnEdgeCoversWhatItsAreaSays) {
  const Scene scene = half_plane();
  for (const SamplePattern pattern :
       {SamplePattern::grid, SamplePattern::jitter, SamplePattern::random, SamplePattern::halton, SamplePattern::r2}) {
    Settings settings = samples(64, pattern);
    settings.lighting = false;
    settings.near = 0.5;
    const Frame frame = traced(scene, settings, side, side);
    double sum = 0, worst = 0;
    int edges = 0;
    for (int row = 0; row < side; ++row)
      for (int column = 0; column < side; ++column) {
        const int right = column - side / 2, up = side / 2 - row - 1;
        const double exact = coverage(right, up);
        const double error = static_cast<double>(frame.colour.at(column, row).x) - exact;
        constexpr double rounding = 1e-12;  // of the integral
        if (exact > rounding && exact < 1 - rounding)
          ++edges;
        else
          EXPECT_NEAR(error, 0, rounding) << column << " " << row;
        sum += error;
        worst = std::max(worst, std::abs(error));
      }
    ASSERT_GT(edges, 30);
    const bool random = pattern == SamplePattern::random;
    EXPECT_LT(worst, random ? 0.35 : 0.125) << static_cast<int>(pattern);
    EXPECT_LT(std::abs(sum / edges), random ? 0.03 : 0.01) << static_cast<int>(pattern);
  }
}

TEST(Sampling, ACheckerFromAfarIsGrey) {
  const Scene scene =
      parse_scene("viewport_size = 1 x 1\nprojection_plane_d = 1\nbackground = black\n"
                  "texture { name = squares  generator = checker  size = 8 }\n"
                  "plane { point = (0, 0, 40)  normal = (0, 0, -1)  color = white  texture = squares }\n",
                  "checker.scene", ".");
  Settings settings = samples(1024, SamplePattern::r2);
  settings.lighting = false;
  settings.texture_filter = TextureFilter::nearest;
  const Frame frame = traced(scene, settings, 8, 8);  // each pixel is five checkers wide
  for (const Vec3f& colour : frame.colour.pixels()) EXPECT_NEAR(colour.x, 0.5f, 0.01f);
  const Frame one = traced(
      scene,
      [&] {
        Settings s = settings;
        s.samples_per_pixel = 1;
        s.sample_pattern = SamplePattern::grid;
        return s;
      }(),
      8, 8);
  for (const Vec3f& colour : one.colour.pixels()) EXPECT_TRUE(colour.x == 0 || colour.x == 1);
}

// A grid of n x n samples is the picture at n times the size, made smaller by the mean of each n x n block. Scaling by
// a power of two rounds nothing, so the rays are the same to the bit; the sum in the same order then is, too.
TEST(Sampling, TheGridIsALargerPictureMadeSmaller) {
  const Scene scene = load_scene("cgfs/reflections");
  constexpr int width = 61, height = 47;
  for (const int n : {2, 3, 4, 8}) {
    const Frame small = traced(scene, samples(n * n), width, height);
    const Frame large = traced(scene, {}, n * width, n * height);
    double worst = 0;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        Vec3f sum(0);
        for (int i = 0; i < n * n; ++i) sum += large.colour.at(n * x + i % n, n * y + i / n);
        const Vec3f expected = sum / static_cast<float>(n * n);
        if (n == 3)
          for (int k = 0; k < 3; ++k)
            worst = std::max(worst, static_cast<double>(std::abs(expected[k] - small.colour.at(x, y)[k])));
        else
          ASSERT_EQ(expected, small.colour.at(x, y)) << n << " at " << x << " " << y;
      }
    // Thirds are rounded: a ray may end up on the other side of an edge, never more than one of nine.
    if (n == 3) {
      EXPECT_LT(worst, 0.12);
    }
  }
}

TEST(Sampling, AdaptiveIsFullWhereSubdividedAndPlainElsewhere) {
  const Scene scene = load_scene("cgfs/fence");
  Settings settings = samples(16, SamplePattern::jitter);
  settings.adaptive_threshold = 0.05;
  const Frame full = traced(scene, settings, 97, 80, Channel::samples);
  const Frame one = traced(
      scene,
      [&] {
        Settings s = settings;
        s.samples_per_pixel = 1;
        s.sample_pattern = SamplePattern::grid;
        return s;
      }(),
      97, 80, Channel::samples | Channel::ids);
  settings.adaptive_sampling = true;
  const Frame adaptive = traced(scene, settings, 97, 80, Channel::samples);
  EXPECT_TRUE(adaptive.ids.empty());
  std::uint64_t subdivided = 0, by_rule = 0;
  const auto differ = [&](Vec2i a, Vec2i b) {
    const Vec3f apart = one.colour.at(a.x, a.y) - one.colour.at(b.x, b.y);  // all colours here lie in [0, 1]
    return one.ids.at(a.x, a.y).object != one.ids.at(b.x, b.y).object ||
           std::max({std::abs(apart.x), std::abs(apart.y), std::abs(apart.z)}) > 0.05f;
  };
  for (int y = 0; y < 80; ++y)
    for (int x = 0; x < 97; ++x) {
      const bool chosen = (x > 0 && differ({x, y}, {x - 1, y})) || (x < 96 && differ({x, y}, {x + 1, y})) ||
                          (y > 0 && differ({x, y}, {x, y - 1})) || (y < 79 && differ({x, y}, {x, y + 1}));
      by_rule += chosen ? 1 : 0;
      ASSERT_EQ(adaptive.samples.at(x, y), chosen ? 16u : 1u) << x << " " << y;
      ASSERT_EQ(adaptive.colour.at(x, y), (chosen ? full : one).colour.at(x, y)) << x << " " << y;
      subdivided += adaptive.samples.at(x, y) == 16 ? 1 : 0;
    }
  EXPECT_EQ(adaptive.counters[Counter::pixels_subdivided], subdivided);
  EXPECT_EQ(subdivided, by_rule);
  EXPECT_GT(subdivided, 100u);
  EXPECT_LT(subdivided, 97u * 80u * 3 / 4);
  EXPECT_EQ(adaptive.counters[Counter::eye_rays], 97u * 80u + 16 * subdivided);
  for (const std::uint32_t count : full.samples.pixels()) ASSERT_EQ(count, 16u);
}

// Without anything smaller than the step, subsampling gives the plain picture: here to the last bit, for the step lies
// below the size of every sphere.
TEST(Sampling, SubsamplingIsExactOnLargeObjects) {
  for (const char* name : {"cgfs/reflections", "cgfs/spheres"}) {
    const Scene scene = load_scene(name);
    const Frame plain = traced(scene, {}, 128, 96);
    for (const int step : {2, 4}) {
      Settings settings;
      settings.subsampling = step;
      const Frame fewer = traced(scene, settings, 128, 96);
      int differing = 0;
      for (int y = 0; y < 96; ++y)
        for (int x = 0; x < 128; ++x) differing += fewer.colour.at(x, y) != plain.colour.at(x, y);
      EXPECT_LE(differing, 12 * step) << name << " " << step;  // slivers of an outline inside a cell
      EXPECT_GT(fewer.counters[Counter::searches_saved], 128u * 96u / 2);
      EXPECT_LT(fewer.counters[Counter::sphere_tests], plain.counters[Counter::sphere_tests]);
    }
  }
}

TEST(Sampling, SubsamplingMissesThinWires) {
  const Scene scene = load_scene("cgfs/fence");
  const auto wire_pixels = [&](int step) {
    Settings settings;
    settings.subsampling = step;
    const TileRect wires{0, 200, 600, 256};  // and nothing else before the wall
    const Frame frame = traced(scene, settings, 600, 600, Channel::ids, wires);
    int count = 0;
    for (int y = wires.y0; y < wires.y1; ++y)
      for (int x = wires.x0; x < wires.x1; ++x) {
        const auto object = frame.ids.at(x, y).object;
        count += object >= 3 && object <= 8;
      }
    return count;
  };
  const int all = wire_pixels(1);
  EXPECT_GE(all, 6 * 56);
  EXPECT_EQ(wire_pixels(2), all);  // each is two pixels wide
  EXPECT_EQ(wire_pixels(16), 0);
  EXPECT_LT(wire_pixels(8), all / 4);
}

}  // namespace
}  // namespace ps::sampling_test
