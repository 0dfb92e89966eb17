#include "raster/clear/coverage/inexact_edges.h"
#include "raster/clear/interpolate.h"
#include "study/stability/jittered_mesh.h"

namespace ps::stability::fill_rules {
namespace {

enum class Width { int64, int32 };

/// Draws a mesh with the program's edge functions and counts how often each pixel is painted.
Image<int> painted_times(const FlatMesh& mesh, int side, FillRule rule, Width width) {
  Image<int> times(side, side);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    for_pixels_in_box(mesh, i, 8, rule, side, [&](const auto& edges, int x, int y) {
      const auto value = edges.at(x, y);
      bool inside = edges.inside(value);
      if (width == Width::int32) {
        inside = true;
        for (std::size_t k = 0; k < 3; ++k)
          inside = inside && raster::inside_edge(raster::wrapped(value[k], 8), edges.threshold[k]);
      }
      times.at(x, y) += inside ? 1 : 0;
    });
  return times;
}

constexpr int window = 655;  ///< its 429,025 pixels lie inside the mesh, however that is turned

/// `cells` x `cells` cells, every vertex moved by up to a fifth of a cell, turned by half a radian: edges of every
/// slope, and none of the mesh's rim in the window.
FlatMesh turned_mesh(int cells, double grid, const StabilityRun& run) {
  Random random(run.seed);
  const double middle = window / 2.0, half = middle * std::sqrt(2.0);
  return turned(jittered_mesh(cells, middle - half, middle + half, 0.2, 0, random), Vec2d(middle, middle), 0.5, grid);
}

/// 32 x 31 pixels each: the edges run through samples, the diagonals through hardly any.
FlatMesh rectangles() {
  Random unused(0);
  FlatMesh mesh = jittered_mesh(22, 0, 22, 0, 1, unused);
  for (Vec2d& p : mesh.points) p = {0.5 + 32 * p.x, 0.5 + 31 * p.y};
  return mesh;
}

/// 7,200 triangles with vertices on half pixels, or rectangles whose edges run through samples.
void measure_easy(const StabilityRun& run, Rows& rows) {
  for (const bool squares : {false, true}) {
    run.check();
    const FlatMesh mesh = squares ? rectangles() : turned_mesh(60, 0.5, run);
    const auto painted = [&](FillRule rule) {
      return count_painted(painted_times(mesh, window, rule, Width::int64), 0, window);
    };
    const Painted robust = painted(FillRule::top_left);
    for (const FillRule rule : {FillRule::inclusive, FillRule::exclusive}) {
      const Painted naive = painted(rule);
      const std::string name = std::string(squares ? "edges on samples" : "vertices on half pixels") +
                               (rule == FillRule::inclusive ? ", >= 0" : ", > 0");
      const double knob = rule == FillRule::inclusive ? 0 : 1;
      rows.add(knob, name + ", holes", naive.holes, robust.holes, "px of 429,025");
      rows.add(knob, name + ", doubles", naive.doubles, robust.doubles, "px of 429,025");
    }
  }
}

void measure_int32(const StabilityRun& run, Rows& rows) {
  for (const int cells : {16, 8, 6, 5, 4, 3}) {
    run.check();
    const FlatMesh mesh = turned_mesh(cells, 0, run);
    const auto holes = [&](Width width) {
      return count_painted(painted_times(mesh, window, FillRule::top_left, width), 0, window).holes;
    };
    // A triangle is half a cell.
    rows.add(window / static_cast<double>(cells), "square root of a triangle's area", holes(Width::int32),
             holes(Width::int64), "holes, px of 429,025");
  }
}

/// The book's DrawFilledTriangle (CGFS ch. 7): from the rounded left edge to the rounded right edge, both included,
/// from the first row to the last, both included.
void book_triangle(std::array<Vec2d, 3> p, Image<int>& times) {
  for (Vec2d& corner : p) corner = {std::round(corner.x), std::round(corner.y)};
  if (p[1].y < p[0].y) std::swap(p[0], p[1]);
  if (p[2].y < p[0].y) std::swap(p[0], p[2]);
  if (p[2].y < p[1].y) std::swap(p[1], p[2]);
  raster::InterpolatedValues<double> whole(p[0].y, p[0].x, p[2].y, p[2].x), upper(p[0].y, p[0].x, p[1].y, p[1].x),
      lower(p[1].y, p[1].x, p[2].y, p[2].x);
  for (int y = static_cast<int>(p[0].y); y <= static_cast<int>(p[2].y); ++y) {
    const double a = whole.at(y - static_cast<int>(p[0].y));
    const double b =
        y < static_cast<int>(p[1].y) ? upper.at(y - static_cast<int>(p[0].y)) : lower.at(y - static_cast<int>(p[1].y));
    for (int x = static_cast<int>(std::lround(std::min(a, b))); x <= static_cast<int>(std::lround(std::max(a, b))); ++x)
      if (times.contains(x, y)) ++times.at(x, y);
  }
}

void measure_inclusive(const StabilityRun& run, Rows& rows) {
  for (const double size : {100.0, 50.0, 21.0, 10.0, 5.0, 3.0}) {
    run.check();
    Random random(run.seed);
    const int cells = static_cast<int>(600 / size);
    const FlatMesh mesh = jittered_mesh(cells, 10, 10 + cells * size, 0.3, 0, random);
    Image<int> times(640, 640);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) book_triangle(mesh.corners(i), times);
    const int last = 10 + static_cast<int>(cells * size);
    const Painted naive = count_painted(times, 11, last);
    const Painted robust = count_painted(painted_times(mesh, 640, FillRule::top_left, Width::int64), 11, last);
    rows.add(size, "mesh", percent(naive.doubles, naive.pixels), percent(robust.doubles, robust.pixels),
             "% of pixels painted more than once");
  }
}

}  // namespace

extern const StabilityExperiment fill_rule_easy{
    .key = "fill-rule-easy",
    .place = {Subject::coverage, 10},
    .title = "Fill rule: which triangle owns an edge",
    .keywords = "fill rule, top-left rule, shared edge, double hit",
    .knob = "fill rule",
    .naive = "inside where all edge values are >= 0, or > 0 (fill-rule = inclusive, exclusive)",
    .robust = "top-left rule",
    .explanation = "If a sample lies exactly on a shared edge, both triangles decide alike: both paint it, or neither "
                   "does. The top-left rule gives it to one of them. The number of samples on edges depends on the "
                   "mesh. Here it has 60 x 60 cells of 15 px and is turned by half a radian. Each vertex is moved by "
                   "up to a fifth of a cell and rounded to half pixels.",
    .safe = "Meshes without a sample on an edge.",
    .window = nowhere_safe,
    .series = {{.names = "*holes", .title = "pixels that no triangle paints", .unit = "px of 429,025"},
               {.names = "*doubles", .title = "pixels that two triangles paint", .unit = "px of 429,025"}},
    .add_rows = measure_easy};

extern const StabilityExperiment int32_edge_functions{
    .key = "int32-edge-functions",
    .place = {Subject::coverage, 30},
    .title = "Integer overflow: edge functions in 32 bits",
    .keywords = "overflow, integer overflow, fixed point, wrap-around",
    .knob = "square root of a triangle's area (px)",
    .naive = "32-bit integers with 8 sub-pixel bits (edge-arithmetic = int32)",
    .robust = "64-bit integers (edge-arithmetic = fixed)",
    .explanation = "An edge value is twice the area of the triangle that edge and sample form, in units of 1/65,536 "
                   "square pixels. From 32,768 square pixels (181 by 181) on it needs more than 31 bits, and in 32 "
                   "bits its sign changes.",
    .safe = "Triangles with edges of up to 128 pixels, whose areas are at most half of 128 by 128.",
    .window = {nowhere, 90},
    .series = {{.names = "*", .title = "pixels that no triangle paints", .unit = "px of 429,025"}},
    .add_rows = measure_int32};

extern const StabilityExperiment inclusive_scanlines{
    .key = "inclusive-scanlines",
    .place = {Subject::coverage, 80},
    .title = "Scanlines with both ends",
    .keywords = "fill rule, shared edge, overlap, double hit",
    .knob = "length of a triangle's legs (px)",
    .naive = "the book's filling, both ends of a row included",
    .robust = "top-left rule",
    .explanation = "Rows from the rounded left edge to the rounded right edge, both included, paint every shared edge "
                   "twice. The smaller the triangles, the more of their pixels lie on edges.",
    .safe = "Opaque triangles, where painting a pixel twice only costs time.",
    .window = nowhere_safe,
    .series = {{.names = "*", .title = "pixels painted more than once", .unit = "%"}},
    .add_rows = measure_inclusive};

}  // namespace ps::stability::fill_rules
