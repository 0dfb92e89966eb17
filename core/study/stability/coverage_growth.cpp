#include <array>

#include "raster/clear/coverage/walk.h"
#include "study/stability/support.h"

namespace ps::stability::coverage_growth {
namespace {

using raster::FixedPoint;

/// Counts what a strategy tests: samples, and rows, cells or pieces.
struct CountingSink {
  double tests = 0, covered = 0;
  void test(int, int) { ++tests; }
  void test_all(const TileRect& box) { tests += static_cast<double>(box.x1 - box.x0) * (box.y1 - box.y0); }
  void region(const TileRect&) { ++tests; }
  template <class... Values>
  void cover(int, int, const Values&...) {
    ++covered;
  }
};

/// A triangle given in pixels, by its vertices.
struct PixelTriangle {
  const char* name;
  std::array<Vec2i, 3> vertices;
};

raster::CoverageInput growth_input(const PixelTriangle& triangle) {
  const raster::CoverageGrid grid{8, FillRule::top_left, {0.5, 0.5}};
  std::array<FixedPoint, 3> corners;
  const auto unit = static_cast<int>(raster::fixed_unit(grid.subpixel_bits));
  for (std::size_t i = 0; i < 3; ++i) corners[i] = {triangle.vertices[i].x * unit, triangle.vertices[i].y * unit};
  const auto edges = raster::make_edges(corners, grid);
  PS_ASSERT(edges, "the triangle has an area");
  return {corners, *edges, grid, raster::sample_box(corners, grid), Projection::perspective};
}

CountingSink tests_of(Coverage strategy, const raster::CoverageInput& input) {
  CountingSink sink;
  raster::walk_coverage<double>({strategy, EdgeArithmetic::fixed}, input, input.whole, sink);
  return sink;
}

struct GrowingStrategy {
  const char* name;
  Coverage strategy;
};
constexpr std::array growing{
    GrowingStrategy{"scanline", Coverage::scanline}, GrowingStrategy{"hierarchical", Coverage::hierarchical},
    GrowingStrategy{"tiled", Coverage::tiled}, GrowingStrategy{"micropolygons", Coverage::micropolygon}};

/// Tests of samples, rows, cells or pieces for one triangle whose box is `side` pixels wide and high: half of the box,
/// and a thin triangle along its diagonal, two pixels high at one end, whose area is `side` pixels (CGPP 15.6.6,
/// ex. 15.4).
void measure_growth(const StabilityRun& run, Rows& rows) {
  for (const int side : {8, 16, 32, 64, 128, 256, 512}) {
    const std::array triangles{PixelTriangle{"half of the box", {{{0, 0}, {side, 0}, {0, side}}}},
                               PixelTriangle{"thin", {{{0, 0}, {side, side - 2}, {side, side}}}}};
    for (const PixelTriangle& triangle : triangles) {
      run.check();
      const raster::CoverageInput input = growth_input(triangle);
      const CountingSink box = tests_of(Coverage::bounding_box, input);
      for (const GrowingStrategy& one : growing) {
        const CountingSink sink = tests_of(one.strategy, input);
        PS_ASSERT(sink.covered == box.covered, "all strategies find the same samples");
        rows.add(side, std::string(triangle.name) + ", " + one.name, box.tests, sink.tests, "tests");
      }
    }
  }
}

}  // namespace

extern const StabilityExperiment coverage_growth{
    .key = "coverage-growth",
    .place = {Subject::coverage, 70},
    .title = "Tests grow with the bounding box",
    .keywords = "overdraw, bounding box, half-space, efficiency",
    .knob = "side of the triangle's bounding box (px)",
    .naive = "every sample of the box",
    .robust = "rows, cells, tiles or pieces",
    .explanation =
        "A box of side n has n^2 samples, but a thin triangle in it covers only n of them. Rows are n, cells about 5 n "
        "and the n^2 / 4096 coarsest ones, tiles n^2 / 64. Pieces as small as a pixel are more than n^2 in either "
        "triangle, for a thin one is cut as often as a wide one.",
    .safe = "Triangles of a few pixels: then the box has hardly more samples than the triangle.",
    .window = {0, 8},
    .series = {{.names = "*", .title = "samples, rows, cells and pieces tested", .unit = "tests"}},
    .add_rows = measure_growth};

}  // namespace ps::stability::coverage_growth
