#include "raster/clear/coverage/walk.h"
#include "study/stability/support.h"

namespace ps::stability::stepped_edge_drift {
namespace {

/// The columns of one row that the program covers, as a coverage sink.
struct RowSink {
  std::vector<char> covered;
  void test(int, int) {}
  void test_all(const TileRect&) {}
  void region(const TileRect&) {}
  template <class... Values>
  void cover(int column, int, const Values&...) {
    covered[static_cast<std::size_t>(column)] = 1;
  }
};

/// Triangles anywhere on a canvas, covered by the program with each edge arithmetic: how many pixels change sides
/// against exact integers, for each pixel that an edge passes through. 64 rows of each canvas are looked at.
void measure(const StabilityRun& run, Rows& rows) {
  constexpr int rows_looked_at = 64;
  for (const int canvas : {1024, 4096, 16384}) {
    Random random(run.seed);
    double naive = 0, robust = 0, edge_pixels = 0;
    const raster::CoverageGrid grid{8, FillRule::top_left, {0.5, 0.5}};
    const int triangles = run.count(200 * 4096 / canvas, 24);
    for (int i = 0; i < triangles; ++i) {
      run.check();
      const auto any = [&] { return random.between(0, canvas); };
      std::array<raster::FixedPoint, 3> corners;
      for (raster::FixedPoint& corner : corners) corner = raster::to_fixed(Vec2d(any(), any()), grid.subpixel_bits);
      const auto edges = raster::make_edges(corners, grid);
      if (!edges) continue;
      const TileRect whole = common_part(raster::sample_box(corners, grid), {0, 0, canvas, canvas});
      const raster::CoverageInput input{corners, *edges, grid, whole};
      for (int row = whole.y0; row < whole.y1; ++row) {
        if (row % (canvas / rows_looked_at) != 0) continue;
        const auto covered = [&](EdgeArithmetic arithmetic) {
          RowSink sink{std::vector<char>(static_cast<std::size_t>(canvas), 0)};
          raster::walk_coverage<float>({Coverage::edge_function, arithmetic}, input, {whole.x0, row, whole.x1, row + 1},
                                       sink);
          return sink.covered;
        };
        const std::vector<char> exact = covered(EdgeArithmetic::fixed);
        const auto differing = [&](const std::vector<char>& other) {
          double count = 0;
          for (std::size_t k = 0; k < exact.size(); ++k) count += exact[k] != other[k] ? 1 : 0;
          return count;
        };
        naive += differing(covered(EdgeArithmetic::float_stepped));
        robust += differing(covered(EdgeArithmetic::float32));
        for (std::size_t k = 0; k < 3; ++k) {  // how many pixels of this row the edge passes through
          const Vec2d a(corners[k].x, corners[k].y), b(corners[(k + 1) % 3].x, corners[(k + 1) % 3].y);
          const double y = (row + 0.5) * static_cast<double>(raster::fixed_unit(grid.subpixel_bits));
          if ((a.y < y) != (b.y < y)) edge_pixels += 1 + std::abs((b.x - a.x) / (b.y - a.y));
        }
      }
    }
    rows.add(canvas, "triangles on the canvas", naive / edge_pixels, robust / edge_pixels, "wrong px per edge px");
  }
}

}  // namespace

extern const StabilityExperiment stepped_edge_drift{
    .key = "stepped-edge-drift",
    .place = {Subject::coverage, 40},
    .title = "Incremental error: stepped edges drift",
    .keywords = "incremental, accumulated error, DDA, float, cracks",
    .knob = "side of the canvas (px)",
    .naive = "float, one addition for each sample (edge-arithmetic = float-stepped)",
    .robust = "float, each sample computed afresh (edge-arithmetic = float)",
    .explanation = "An edge value near zero is what is left of many additions to a large one, and each of them was "
                   "rounded to the spacing of the large one. The error grows with the square of the canvas.",
    .safe = "Canvases up to 1,000 pixels for one pixel in a thousand.",
    .window = {nowhere, 1024},
    .series = {{.names = "*", .title = "wrong pixels for each pixel of an edge", .unit = "px per px"}},
    .add_rows = measure};

}  // namespace ps::stability::stepped_edge_drift
