#include <array>
#include <numeric>

#include "raster/base/edge_function.h"
#include "raster/clear/coverage/walk.h"
#include "study/stability/edge_methods.h"
#include "study/stability/jittered_mesh.h"
#include "study/stability/support.h"

namespace ps::stability::shared_edges {
namespace {

using raster::CoverageChoice;
using raster::FixedPoint;

constexpr int canvas = 600;  ///< px, the book's

struct Tally {
  double holes = 0, doubles = 0;
  void add(int painted) {
    holes += painted == 0 ? 1 : 0;
    doubles += painted > 1 ? 1 : 0;
  }
  Tally per_million_of(int edges) const { return {per_million(holes, edges), per_million(doubles, edges)}; }
};

void add_rows(Rows& rows, double knob, const std::string& series, const Tally& naive, const Tally& robust) {
  rows.add(knob, series + ", holes", naive.holes, robust.holes, "per million edges");
  rows.add(knob, series + ", doubles", naive.doubles, robust.doubles, "per million edges");
}

template <class Corners>
Corners in_any_order(const Corners& c, Random& random) {
  const std::size_t first = random.below(3);
  return {c[first], c[(first + 1) % 3], c[(first + 2) % 3]};
}

/// Ways to ask whether a triangle whose vertices are any floats covers a sample, as published or in common use. The
/// program rounds vertices to sub-pixels first.
struct Method {
  std::string name;
  bool (*naive)(const Corners&, const Vec2f&);
  bool (*robust)(const Corners&, const Vec2f&);
};
const std::array methods{Method{"float, own order", covers_relative, covers_canonical},
                         Method{"float, stepped", covers_stepped, covers_fixed<8>},
                         Method{"float, A x + B y + C", covers_absolute, covers_fixed<8>},
                         Method{"float, all >= 0", covers_inclusive, covers_canonical},
                         Method{"float, all > 0", covers_exclusive, covers_canonical},
                         Method{"float, u, v, 1 - u - v >= 0", covers_barycentric, covers_canonical},
                         Method{"4 sub-pixel bits beside 8", covers_fixed<4>, covers_fixed<8>}};

/// Where edges are aimed at samples, and how many: the rarer the failures, the more are needed to count them.
struct Place {
  float length = 0, offset = 0;  ///< px: of the edges; of the canvas from the origin, in both directions
  int edges = 0;
  const char* name = "";
};

/// Two triangles on both sides of an edge that passes a sample as nearly as rounded vertices let it.
void aim_edges(Rows& rows, const Place& at, const StabilityRun& run) {
  Random random(run.seed);
  std::array<Tally, methods.size()> naive, robust;
  const int edges = run.count(at.edges, 20000);
  for (int trial = 0; trial < edges; ++trial) {
    if (trial % 65536 == 0) run.check();
    const auto place = [&] { return at.offset + static_cast<float>(random.below(canvas)) + 0.5f; };
    const Vec2f sample(place(), place());
    const float angle = static_cast<float>(random.between(0, 2 * pi));
    const Vec2f along(std::cos(angle), std::sin(angle)), across(-along.y, along.x);
    const float split = static_cast<float>(random.between(0.1, 0.9));
    const Vec2f a = sample - along * (at.length * split);
    const Vec2f b = sample + along * (at.length * (1 - split));
    const Vec2f left = sample + across * (at.length * static_cast<float>(random.between(0.4, 1)));
    const Vec2f right = sample - across * (at.length * static_cast<float>(random.between(0.4, 1)));
    const Corners one = in_any_order(Corners{a, b, left}, random), other = in_any_order(Corners{b, a, right}, random);
    for (std::size_t m = 0; m < methods.size(); ++m) {
      naive[m].add(methods[m].naive(one, sample) + methods[m].naive(other, sample));
      robust[m].add(methods[m].robust(one, sample) + methods[m].robust(other, sample));
    }
  }
  for (std::size_t m = 0; m < methods.size(); ++m)
    add_rows(rows, at.length, methods[m].name + at.name, naive[m].per_million_of(edges),
             robust[m].per_million_of(edges));
}

using GridVector = glm::vec<2, std::int64_t>;

/// Vertices a and b on the program's sub-pixel grid, on both sides of the origin, whose line passes it as nearly as any
/// two such vertices let it: the triangle that they form with the origin has an area of half a unit. In units of the
/// grid; about `length` apart.
std::pair<GridVector, GridVector> nearest_edge(std::int64_t length, Random& random) {
  const auto any = [&] {
    return static_cast<std::int64_t>(random.below(static_cast<std::size_t>(length))) - length / 2;
  };
  while (true) {
    const GridVector a(any(), any());
    if (16 * (a.x * a.x + a.y * a.y) < length * length || std::gcd(a.x, a.y) != 1) continue;
    GridVector s(1, 0), next(0, 1);  // extended Euclid: a.x s.x + a.y s.y is 1 or -1 in the end
    for (std::int64_t r = a.x, remainder = a.y; remainder != 0;) {
      const std::int64_t quotient = r / remainder;
      r = std::exchange(remainder, r - quotient * remainder);
      s = std::exchange(next, s - next * quotient);
    }
    GridVector b(-s.y, s.x);
    if (random.coin()) b = -b;
    while (b.x * a.x + b.y * a.y >= 0) b -= a;
    return {a, b};
  }
}

/// The program's own ways to decide coverage, on edges that pass a sample as nearly as sub-pixels let them.
void aim_at_program(Rows& rows, int length, const StabilityRun& run) {
  const std::array choices{CoverageChoice{Coverage::edge_function, EdgeArithmetic::float32},
                           CoverageChoice{Coverage::edge_function, EdgeArithmetic::float_stepped},
                           CoverageChoice{Coverage::edge_function, EdgeArithmetic::fixed}};
  constexpr std::size_t fixed = 2;
  const raster::CoverageGrid grid{8, FillRule::top_left, {0.5, 0.5}};
  const int unit = static_cast<int>(raster::fixed_unit(grid.subpixel_bits));
  Random random(run.seed);
  std::array<Tally, choices.size()> tallies;
  const int edges = run.count(40000, 10000);
  for (int trial = 0; trial < edges; ++trial) {
    if (trial % 16384 == 0) run.check();
    const int column = static_cast<int>(random.below(canvas)), row = static_cast<int>(random.below(canvas));
    const auto [a, b] = nearest_edge(length * unit / 2, random);
    const GridVector across(a.y - b.y, b.x - a.x);
    std::array<int, choices.size()> painted{};
    for (const int side : {1, -1}) {
      const auto vertex = [&](const GridVector& at) {  // a unit of FixedPoint is half of one of the grid
        return FixedPoint{column * unit + unit / 2 + 2 * static_cast<std::int32_t>(at.x),
                          row * unit + unit / 2 + 2 * static_cast<std::int32_t>(at.y)};
      };
      const std::array triangle{vertex(side > 0 ? a : b), vertex(side > 0 ? b : a),
                                vertex(across * std::int64_t{side} / std::int64_t{2})};
      const auto corners = in_any_order(triangle, random);
      const auto sides = raster::make_edges(corners, grid);
      const raster::CoverageInput input{corners, *sides, grid, raster::sample_box(corners, grid)};
      for (std::size_t k = 0; k < choices.size(); ++k)
        painted[k] += raster::decide_sample<float>(choices[k], input, column, row).covered ? 1 : 0;
    }
    for (std::size_t k = 0; k < choices.size(); ++k) tallies[k].add(painted[k]);
  }
  const char* names[] = {"edge-arithmetic = float", "edge-arithmetic = float-stepped"};
  for (std::size_t k = 0; k < fixed; ++k)
    add_rows(rows, length, names[k], tallies[k].per_million_of(edges), tallies[fixed].per_million_of(edges));
}

/// 7,200 triangles with vertices at random floats, none of them aimed at a sample, over the same 429,025 pixels as in
/// "fill-rule-easy": pixels that no triangle or more than one paints.
double wrong_in_random_mesh(bool (*covers)(const Corners&, const Vec2f&), const StabilityRun& run) {
  run.check();
  constexpr int side = 655;
  Random random(run.seed);
  const double middle = side / 2.0, half = middle * std::sqrt(2.0);
  const FlatMesh mesh =
      turned(jittered_mesh(60, middle - half, middle + half, 0.2, 0, random), Vec2d(middle, middle), 0.5, 0);
  Image<int> times(side, side);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto exact = mesh.corners(i);
    const Corners p{Vec2f(exact[0]), Vec2f(exact[1]), Vec2f(exact[2])};
    const auto [x0, x1] = std::minmax({p[0].x, p[1].x, p[2].x});
    const auto [y0, y1] = std::minmax({p[0].y, p[1].y, p[2].y});
    for (int y = std::max(0, static_cast<int>(y0)); y <= std::min(side - 1, static_cast<int>(y1)); ++y)
      for (int x = std::max(0, static_cast<int>(x0)); x <= std::min(side - 1, static_cast<int>(x1)); ++x)
        times.at(x, y) += covers(p, {static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f}) ? 1 : 0;
  }
  const Painted painted = count_painted(times, 0, side);
  return painted.holes + painted.doubles;
}

void measure_adversarial(const StabilityRun& run, Rows& rows) {
  for (const int length : {10, 100, 1000}) aim_at_program(rows, length, run);
  for (const Place& place :
       {Place{10, 0, 400000, ""}, {100, 0, 100000, ""}, {1000, 0, 50000, ""}, {10, 16000, 1200000, " at 16,000 px"}})
    aim_edges(rows, place, run);
  for (const Method& method : methods)
    rows.add(15, method.name + ", random mesh", wrong_in_random_mesh(method.naive, run),
             wrong_in_random_mesh(method.robust, run), "holes and doubles, px of 429,025");
}

}  // namespace

extern const StabilityExperiment fill_rule_adversarial{
    .key = "fill-rule-adversarial",
    .place = {Subject::coverage, 20},
    .title = "Fill rule: edges through a sample",
    .keywords = "fill rule, top-left rule, tie, shared edge",
    .knob = "length of the edge (px)",
    .naive = "edge functions in float",
    .robust = "vertices in one order for both triangles, or 64-bit integers (edge-arithmetic = fixed)",
    .explanation =
        "Two triangles start their shared edge at different ends, so a sample within rounding of it may lie outside "
        "both or inside both. Random meshes hardly ever show it, whatever the method: edges have to be aimed.",
    .safe = "Nowhere for edges that pass a sample within an ulp.",
    .window = nowhere_safe,
    .series = {{.names = "float, own order, holes|*holes",
                .title = "samples that no triangle owns",
                .unit = "per million edges"},
               {.names = "*doubles", .title = "samples that both triangles own", .unit = "per million edges"},
               {.names = "*random mesh", .title = "holes and doubles of a random mesh", .unit = "px of 429,025"}},
    .add_rows = measure_adversarial};

}  // namespace ps::stability::shared_edges
