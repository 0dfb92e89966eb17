// Every coverage strategy finds exactly the samples that rational arithmetic finds, and gives a sample on a shared edge
// to one triangle (stability rows 17 and 18). Edges are aimed at samples: random meshes would pass wrong code.
#include <gtest/gtest.h>

#include <numeric>
#include <random>
#include <set>

#include "raster/clear/coverage/walk.h"
#include "support/trials.h"

namespace ps::raster::coverage_strategies_test {
namespace {

constexpr unsigned seed = 20261121;
using Sample = std::pair<int, int>;

/// Notes what is covered, and how often.
struct SampleSink {
  std::multiset<Sample> covered;
  int tests = 0, regions = 0;
  void test(int, int) { ++tests; }
  void test_all(const TileRect& box) { tests += (box.x1 - box.x0) * (box.y1 - box.y0); }
  void region(const TileRect&) { ++regions; }
  template <class... Values>
  void cover(int column, int row, const Values&...) {
    covered.insert({column, row});
  }
};

struct Way {
  const char* name;
  CoverageChoice choice;
  bool in_double = true;
};

constexpr EdgeArithmetic fixed = EdgeArithmetic::fixed;
const std::vector<Way>& exact_ways() {
  static const std::vector<Way> ways{{"edge functions", {Coverage::edge_function, fixed}},
                                     {"ray test", {Coverage::ray_test, fixed}},
                                     {"bounding box", {Coverage::bounding_box, fixed}},
                                     {"barycentric", {Coverage::barycentric, fixed}},
                                     {"hoisted", {Coverage::hoisted, fixed}},
                                     {"scanline", {Coverage::scanline, fixed}},
                                     {"hierarchical", {Coverage::hierarchical, fixed}},
                                     {"tiled", {Coverage::tiled, fixed}},
                                     {"micropolygon", {Coverage::micropolygon, fixed}}};
  return ways;
}

SampleSink walk(const Way& way, const CoverageInput& input, const TileRect& box) {
  SampleSink sink;
  if (is_empty(box)) return sink;
  if (way.in_double)
    walk_coverage<double>(way.choice, input, box, sink);
  else
    walk_coverage<float>(way.choice, input, box, sink);
  return sink;
}

std::optional<CoverageInput> make_input(const std::array<FixedPoint, 3>& corners, const CoverageGrid& grid, int size) {
  const auto edges = make_edges(corners, grid);
  if (!edges) return {};
  return CoverageInput{corners, *edges, grid, common_part(sample_box(corners, grid), {0, 0, size, size}),
                       Projection::perspective};
}

/// The question asked anew, in long double, which holds every product here: is the sample left of all three edges?
bool truly_inside(const CoverageInput& input, int column, int row) {
  const long double unit = std::ldexp(1.0L, input.grid.subpixel_bits + 1);
  const long double x = (column + input.grid.sample.x) * unit, y = (row + input.grid.sample.y) * unit;
  const auto& c = input.corners;
  const auto side = [](long double ax, long double ay, long double bx, long double by, long double px, long double py) {
    return (bx - ax) * (py - ay) - (by - ay) * (px - ax);
  };
  const bool turned = side(c[0].x, c[0].y, c[1].x, c[1].y, c[2].x, c[2].y) < 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const FixedPoint& a = c[turned ? (i + 1) % 3 : i];
    const FixedPoint& b = c[turned ? i : (i + 1) % 3];
    const long double s = side(a.x, a.y, b.x, b.y, x, y);
    const bool owned = input.grid.fill_rule == FillRule::inclusive ||
                       (input.grid.fill_rule == FillRule::top_left && (b.y < a.y || (b.y == a.y && b.x > a.x)));
    if (s < 0 || (s == 0 && !owned)) return false;
  }
  return true;
}

TEST(CoverageStrategies, FindWhatRationalArithmeticFinds) {
  std::mt19937 random(seed);
  constexpr int size = 150;
  for (int trial = 0; trial < test::trials(240); ++trial) {
    const int bits = std::array<int, 5>{0, 1, 4, 8, 12}[static_cast<std::size_t>(trial % 5)];
    const auto rule = static_cast<FillRule>(trial / 5 % 3);
    const double at = trial % 7 == 0 ? 0.0 : 0.5;
    const CoverageGrid grid{bits, rule, {at, at}};
    // Half of them on half pixels, where ties are common; some thin, some far larger than the picture.
    const int grain = trial % 2 == 0 && bits > 0 ? 1 << (bits - 1) : 1;
    const int reach = std::array<int, 4>{6, 40, 150, 1500}[static_cast<std::size_t>(trial / 3 % 4)] << bits;
    const int middle = 75 << bits;
    std::uniform_int_distribution<int> place(-reach / grain, reach / grain);
    std::array<FixedPoint, 3> corners;
    for (auto& corner : corners) corner = {2 * (middle + place(random) * grain), 2 * (middle + place(random) * grain)};
    const auto input = make_input(corners, grid, size);
    if (!input || is_empty(input->whole)) continue;
    std::multiset<Sample> expected;
    for (int row = 0; row < size; ++row)
      for (int column = 0; column < size; ++column)
        if (truly_inside(*input, column, row)) expected.insert({column, row});
    for (const Way& way : exact_ways()) {
      if (way.choice.strategy == Coverage::micropolygon && trial % 4 != 0) continue;  // slow
      EXPECT_EQ(walk(way, *input, input->whole).covered, expected)
          << way.name << ", trial " << trial << ", seed " << seed;
      // The same in parts: what a strategy finds does not depend on where tiles begin.
      std::multiset<Sample> parts;
      for (const TileRect& tile : {TileRect{0, 0, 64, 64}, {64, 0, 150, 64}, {0, 64, 64, 150}, {64, 64, 150, 150}})
        parts.merge(walk(way, *input, common_part(input->whole, tile)).covered);
      EXPECT_EQ(parts, expected) << way.name << " in tiles, trial " << trial << ", seed " << seed;
    }
  }
}

TEST(CoverageStrategies, RaysOfAnOrthographicCameraDecideAlike) {
  const CoverageGrid grid{8, FillRule::top_left, {0.5, 0.5}};
  auto input = make_input({FixedPoint{100, 300}, {30000, 9000}, {7000, 40000}}, grid, 100);
  ASSERT_TRUE(input);
  const Way way{"ray test", {Coverage::ray_test, fixed}};
  const auto perspective = walk(way, *input, input->whole).covered;
  input->projection = Projection::orthographic;
  EXPECT_EQ(walk(way, *input, input->whole).covered, perspective);
  EXPECT_GT(perspective.size(), 1000u);
}

/// u.x * v.y - u.y * v.x = 1.
std::array<std::int64_t, 2> one_beside(std::int64_t ux, std::int64_t uy) {
  std::int64_t r0 = ux, r1 = uy, s0 = 1, s1 = 0, t0 = 0, t1 = 1;
  while (r1 != 0) {
    const std::int64_t q = r0 / r1;
    r0 = std::exchange(r1, r0 - q * r1);
    s0 = std::exchange(s1, s0 - q * s1);
    t0 = std::exchange(t1, t0 - q * t1);
  }
  return {-t0 * r0, s0 * r0};
}

struct Tally {
  int pairs = 0, holes = 0, doubles = 0, wrong = 0;
};

/// Two triangles on both sides of an edge that passes a sample at the smallest distance that the grid has, or through
/// it. `wrong` counts samples that a triangle answers otherwise than truth does.
Tally aim(const Way& way, double length, int pairs) {
  constexpr int size = 4096, bits = 8;
  const CoverageGrid grid{bits, FillRule::top_left, {0.5, 0.5}};
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  Tally tally;
  while (tally.pairs < pairs) {
    const int column = 1500 + static_cast<int>(unit(random) * 1000), row = 1500 + static_cast<int>(unit(random) * 1000);
    const std::int64_t sx = (2 * column + 1) << (bits - 1), sy = (2 * row + 1) << (bits - 1);
    const double angle = unit(random) * 6.283185307179586, half = length / 2 * (1 << bits);
    const auto ux = std::llround(half * std::cos(angle)), uy = std::llround(half * std::sin(angle));
    if (std::gcd(ux, uy) != 1) continue;
    const auto beside = one_beside(ux, uy);
    const int offset = tally.pairs % 5 - 2;
    const std::array<std::int64_t, 2> v{ux + offset * beside[0], uy + offset * beside[1]};
    if (std::abs(ux * v[1] - uy * v[0]) != std::abs(offset)) ADD_FAILURE() << "the aim is off";
    const auto point = [](std::int64_t x, std::int64_t y) {
      return FixedPoint{static_cast<std::int32_t>(2 * x), static_cast<std::int32_t>(2 * y)};
    };
    const FixedPoint a = point(sx - ux, sy - uy), b = point(sx + v[0], sy + v[1]);
    const FixedPoint left = point(sx - uy, sy + ux), right = point(sx + uy, sy - ux);
    int owners = 0;
    for (const auto& corners : {std::array<FixedPoint, 3>{a, b, left}, std::array<FixedPoint, 3>{b, a, right}}) {
      const auto input = make_input(corners, grid, size);
      if (!input) continue;
      const bool covered = way.in_double ? decide_sample<double>(way.choice, *input, column, row).covered
                                         : decide_sample<float>(way.choice, *input, column, row).covered;
      owners += covered;
      tally.wrong += covered != truly_inside(*input, column, row);
    }
    tally.holes += owners == 0;
    tally.doubles += owners == 2;
    ++tally.pairs;
  }
  return tally;
}

TEST(CoverageStrategies, GiveEachSampleOnASharedEdgeToOneTriangle) {
  for (const double length : {10.0, 100.0, 1000.0})
    for (const Way& way : exact_ways()) {
      const bool slow = way.choice.strategy == Coverage::micropolygon;
      const Tally tally = aim(way, length, slow ? 500 : 5000);
      EXPECT_EQ(tally.holes + tally.doubles, 0) << way.name << ", length " << length << ", seed " << seed;
      EXPECT_EQ(tally.wrong, 0) << way.name << ", length " << length << ", seed " << seed;
    }
}

// Teeth: what is not exact is caught by the same aim.
TEST(CoverageStrategies, OtherArithmeticFailsAtTheSameSamples) {
  const Way afresh{"float", {Coverage::edge_function, EdgeArithmetic::float32}};
  const Tally in_float = aim(afresh, 1000, 2000);
  EXPECT_GT(in_float.wrong, 200) << "seed " << seed;
  EXPECT_GT(in_float.holes + in_float.doubles, 5) << "seed " << seed;  // rare, for corners lie on the grid
  const Way stepped{"float, stepped", {Coverage::edge_function, EdgeArithmetic::float_stepped}};
  const Tally drifted = aim(stepped, 1000, 300);
  EXPECT_GT(drifted.holes, 10) << "seed " << seed;
  EXPECT_GT(drifted.doubles, 10) << "seed " << seed;
  // Sums of products that are written alike from both ends agree, right or wrong.
  for (const Coverage strategy : {Coverage::barycentric, Coverage::hoisted}) {
    const Tally antisymmetric = aim({"weights in float", {strategy, fixed}, false}, 1000, 2000);
    EXPECT_EQ(antisymmetric.holes + antisymmetric.doubles, 0) << "seed " << seed;
    EXPECT_GT(antisymmetric.wrong, 200) << "seed " << seed;
  }
}

TEST(CoverageStrategies, ThirtyTwoBitsOverflowOnlyInLargeTriangles) {
  const Way narrow{"int32", {Coverage::edge_function, EdgeArithmetic::int32}};
  const CoverageGrid grid{8, FillRule::top_left, {0.5, 0.5}};
  const auto differing = [&](int pixels) {
    const int far = 2 * (pixels << 8);
    const auto input = make_input({FixedPoint{0, 0}, {far, 0}, {0, far}}, grid, 600);
    const auto wanted = walk(exact_ways()[0], *input, input->whole).covered;
    const auto found = walk(narrow, *input, input->whole).covered;
    std::size_t missing = 0;
    for (const Sample& sample : wanted) missing += found.count(sample) == 0;
    return missing;
  };
  EXPECT_EQ(differing(120), 0u);  // stability 2.6 and 6: safe to 128 pixels
  EXPECT_EQ(differing(128), 0u);
  EXPECT_GT(differing(300), 1000u);
}

/// A mesh on half pixels: each interior sample once, twice and more on edges, or never there, as the rule has it.
TEST(CoverageStrategies, FillAMeshAsTheRuleSays) {
  constexpr int cells = 16, side = 6, size = cells * side + 12;
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> jitter(-3, 3);
  std::vector<FixedPoint> points;
  for (int y = 0; y <= cells; ++y)
    for (int x = 0; x <= cells; ++x) {
      const bool border = x == 0 || y == 0 || x == cells || y == cells;
      const auto place = [&](int cell) { return 256 * (2 * (5 + side * cell) + 1 + (border ? 0 : jitter(random))); };
      const int px = place(x);
      points.push_back({px, place(y)});
    }
  for (const FillRule rule : {FillRule::top_left, FillRule::inclusive, FillRule::exclusive})
    for (const Way& way : exact_ways()) {
      SCOPED_TRACE(way.name);
      std::multiset<Sample> painted;
      const auto draw = [&](std::size_t a, std::size_t b, std::size_t c) {
        const auto input = make_input({points[a], points[b], points[c]}, {8, rule, {0.5, 0.5}}, size);
        if (input) painted.merge(walk(way, *input, input->whole).covered);
      };
      for (std::size_t y = 0; y < cells; ++y)
        for (std::size_t x = 0; x < cells; ++x) {
          const std::size_t a = y * (cells + 1) + x, b = a + 1, c = a + cells + 1, d = c + 1;
          draw(a, b, d);
          draw(d, c, a);
        }
      int holes = 0, doubles = 0;
      for (int y = 5; y < 5 + cells * side; ++y)
        for (int x = 5; x < 5 + cells * side; ++x) {
          holes += painted.count({x, y}) == 0;
          doubles += painted.count({x, y}) > 1;
        }
      EXPECT_EQ(holes > 0, rule == FillRule::exclusive) << holes;
      EXPECT_EQ(doubles > 0, rule == FillRule::inclusive) << doubles;
    }
}

TEST(CoverageStrategies, NeedAsManyTestsAsTheirIdeaSays) {
  const CoverageGrid grid{8, FillRule::top_left, {0.5, 0.5}};
  const int far = 2 * (256 << 8);
  const auto input = make_input({FixedPoint{0, 0}, {far, 0}, {0, far}}, grid, 512);
  const auto tests = [&](Coverage strategy) {
    const TileRect box = strategy == Coverage::ray_test ? TileRect{0, 0, 512, 512} : input->whole;
    const SampleSink sink = walk({"", {strategy, fixed}}, *input, box);
    return std::pair(sink.tests, sink.regions);
  };
  using Tests = std::pair<int, int>;
  EXPECT_EQ(tests(Coverage::ray_test), Tests(512 * 512, 0));
  EXPECT_EQ(tests(Coverage::bounding_box), Tests(256 * 256, 0));
  EXPECT_EQ(tests(Coverage::scanline), Tests(0, 256));
  // 32 x 32 tiles, and masks for the 32 on the diagonal.
  EXPECT_EQ(tests(Coverage::tiled), Tests(0, 32 * 32 + 32));
  // 16 cells of 64; the 4 on the diagonal into 16 each, of which 4 into 16 each, of which 4 into 16 samples each.
  EXPECT_EQ(tests(Coverage::hierarchical), Tests(4 * 4 * 4 * 16, 16 + 4 * 16 + 4 * 4 * 16));
}

}  // namespace
}  // namespace ps::raster::coverage_strategies_test
