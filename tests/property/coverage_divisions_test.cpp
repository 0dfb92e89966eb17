// What hoisting saves, counted by the kernel's own code on numbers that count (CGPP ex. 15.3): per sample, barycentric
// weights cost three divisions and the hoisted loop none. Of each covered sample the only division left is that of
// perspective.
#include <gtest/gtest.h>

#include "raster/base/fragment.h"
#include "raster/clear/coverage/walk.h"

namespace ps::raster::coverage_divisions_test {
namespace {

long divisions = 0, multiplications = 0;

/// A double that counts what is done to it. Divisions by a power of two of whole numbers count as well.
struct Counted {
  double value;
  Counted() = default;  // trivial, as glm's vectors want it
  template <class Number>
  requires std::is_arithmetic_v<Number> Counted(Number number)
      : value(static_cast<double>(number)) {}  // NOLINT(google-explicit-constructor): as a double

  Counted& operator+=(const Counted& b) { return value += b.value, *this; }
  Counted& operator-=(const Counted& b) { return value -= b.value, *this; }
  Counted& operator*=(const Counted& b) { return ++multiplications, value *= b.value, *this; }
  Counted& operator/=(const Counted& b) { return ++divisions, value /= b.value, *this; }
  friend Counted operator+(Counted a, const Counted& b) { return a += b; }
  friend Counted operator-(Counted a, const Counted& b) { return a -= b; }
  friend Counted operator*(Counted a, const Counted& b) { return a *= b; }
  friend Counted operator/(Counted a, const Counted& b) { return a /= b; }
  friend bool operator==(const Counted& a, const Counted& b) { return a.value == b.value; }
  friend auto operator<=>(const Counted& a, const Counted& b) { return a.value <=> b.value; }
};

struct Operations {
  long divisions = 0, multiplications = 0;
  int covered = 0;
};

struct CoveredSink {
  int covered = 0;
  void test_all(const TileRect&) {}
  void cover(int, int) { ++covered; }
};

/// A right triangle with legs of `size` pixels, whose box has size x size samples.
CoverageInput triangle(int size) {
  const CoverageGrid grid{8, FillRule::top_left, {0.5, 0.5}};
  CoverageInput input;
  const auto far = static_cast<std::int32_t>(fixed_unit(grid.subpixel_bits) * size);
  input.corners = {FixedPoint{0, 0}, {far, 0}, {0, far}};
  input.edges = *make_edges(input.corners, grid);
  input.grid = grid;
  input.whole = {0, 0, size, size};
  return input;
}

template <class Walk>
Operations count(const Walk& walk) {
  CoveredSink sink;
  divisions = multiplications = 0;
  walk(sink);
  return {divisions, multiplications, sink.covered};
}

Operations naive(int size) {
  const CoverageInput input = triangle(size);
  return count([&](CoveredSink& sink) { walk_barycentric<Counted>(input, input.whole, sink); });
}
Operations hoisted(int size) {
  const CoverageInput input = triangle(size);
  return count([&](CoveredSink& sink) { walk_hoisted<Counted>(input, input.whole, sink); });
}

TEST(CoverageDivisions, TheHoistedLoopDividesPerTriangleAndNotPerSample) {
  const long for_corners = 6;  // to pixels, of three vertices
  for (const int size : {8, 16, 64}) {
    const Operations a = naive(size), b = hoisted(size);
    const long samples = static_cast<long>(size) * size;
    EXPECT_EQ(a.covered, b.covered);
    EXPECT_EQ(a.covered, size * (size - 1) / 2) << "samples on the hypotenuse belong to its other side";
    EXPECT_EQ(a.divisions, (for_corners + 3) * samples) << size;
    EXPECT_EQ(b.divisions, for_corners + 3) << size;
  }
}

// Two multiplications for each weight of a sample are left, and one for each weight of a row.
TEST(CoverageDivisions, TheHoistedLoopMultipliesTwiceForEachWeight) {
  const Operations small = hoisted(8), large = hoisted(16);
  EXPECT_EQ(large.multiplications - small.multiplications, 6 * (16 * 16 - 8 * 8) + 3 * (16 - 8));
}

TEST(CoverageDivisions, ACoveredSampleDividesOnceForPerspective) {
  ScreenTriangle<Counted> triangle;
  triangle.inverse_z = {0.5, 0.25, 0.25};
  TriangleSetup<Counted> setup;
  setup.triangle = &triangle;
  setup.inverse_area = 0.25;
  const RasterInputs<Counted> inputs;
  ASSERT_TRUE(inputs.perspective());
  divisions = 0;
  const Fragment<Counted> fragment = make_fragment(inputs, setup, 0, 0, {2, 1, 1});
  EXPECT_EQ(divisions, 1);
  EXPECT_EQ(fragment.z.value, 1 / 0.375);
}

}  // namespace
}  // namespace ps::raster::coverage_divisions_test
