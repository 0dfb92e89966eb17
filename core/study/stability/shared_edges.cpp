#include <map>

#include "study/stability/edge_methods.h"
#include "study/stability/jittered_mesh.h"

namespace ps::stability {
namespace {

using Covers = bool (*)(const Corners&, const Vec2f&);
struct Tally {
  double holes = 0, doubles = 0;
};

/// Two triangles on both sides of an edge that passes a sample as nearly as rounded corners let it, `length` px long,
/// on a canvas of 768 x 768 px that begins `offset` px right of and below the origin. Counts per million edges.
Tally aim_edges(float length, float offset, Covers covers, const StabilityRun& run) {
  run.check();
  Random random(run.seed);
  Tally tally;
  const int edges = run.count(200000, 20000);
  for (int trial = 0; trial < edges; ++trial) {
    const auto place = [&] { return offset + std::floor(static_cast<float>(random.between(0, 768))) + 0.5f; };
    const Vec2f sample(place(), place());
    const float angle = static_cast<float>(random.between(0, 2 * pi));
    const Vec2f along(std::cos(angle), std::sin(angle)), across(-along.y, along.x);
    const float split = static_cast<float>(random.between(0.1, 0.9));
    const Vec2f a = sample - along * (length * split);
    const Vec2f b = sample + along * (length * (1 - split));
    const Vec2f left = sample + across * (length * static_cast<float>(random.between(0.4, 1)));
    const Vec2f right = sample - across * (length * static_cast<float>(random.between(0.4, 1)));
    const auto any_order = [&](Corners c) {
      const std::size_t first = random.below(3);
      return Corners{c[first], c[(first + 1) % 3], c[(first + 2) % 3]};
    };
    const int painted =
        (covers(any_order({a, b, left}), sample) ? 1 : 0) + (covers(any_order({b, a, right}), sample) ? 1 : 0);
    tally.holes += painted == 0 ? 1 : 0;
    tally.doubles += painted == 2 ? 1 : 0;
  }
  return {per_million(tally.holes, edges), per_million(tally.doubles, edges)};
}

/// 7,200 triangles with corners at random floats, none of them aimed at a sample, over the same 429,025 pixels as in
/// "fill-rule-easy": pixels that no triangle or more than one paints.
double wrong_in_random_mesh(Covers covers, const StabilityRun& run) {
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

std::vector<StabilityRow> measure_adversarial(const StabilityRun& run) {
  struct Method {
    std::string name;
    Covers naive, robust;
  };
  const std::array methods{Method{"float, own order", covers_relative, covers_canonical},
                           Method{"float, stepped", covers_stepped, covers_fixed<8>},
                           Method{"float, A x + B y + C", covers_absolute, covers_fixed<8>},
                           Method{"float, all >= 0", covers_inclusive, covers_canonical},
                           Method{"float, all > 0", covers_exclusive, covers_canonical},
                           Method{"float, u, v, 1 - u - v >= 0", covers_barycentric, covers_canonical},
                           Method{"4 sub-pixel bits beside 8", covers_fixed<4>, covers_fixed<8>}};
  Rows rows(run);
  struct Place {
    float length, offset;
    const char* name;
  };
  constexpr float far_out = 16000;
  for (const Place& place : {Place{10, 0, ""}, {100, 0, ""}, {1000, 0, ""}, {10, far_out, " at 16,000 px"}}) {
    std::map<Covers, Tally> tallies;  // the robust ones serve several series
    const auto tally = [&](Covers covers) {
      const auto found = tallies.find(covers);
      return found != tallies.end() ? found->second
                                    : tallies[covers] = aim_edges(place.length, place.offset, covers, run);
    };
    for (const Method& method : methods) {
      const Tally naive = tally(method.naive), robust = tally(method.robust);
      const std::string name = method.name + place.name;
      rows.push_back({place.length, name + ", holes", naive.holes, robust.holes, "per million edges"});
      rows.push_back({place.length, name + ", doubles", naive.doubles, robust.doubles, "per million edges"});
    }
  }
  for (const Method& method : methods)
    rows.push_back({15, method.name + ", random mesh", wrong_in_random_mesh(method.naive, run),
                    wrong_in_random_mesh(method.robust, run), "holes and doubles, px of 429,025"});
  return rows;
}

/// Triangles anywhere on a canvas, their edges stepped in float from the corner of the triangle's box, against the same
/// in double: of the rows looked at, how many pixels change sides, for each pixel that the edge passes through.
std::vector<StabilityRow> measure_drift(const StabilityRun& run) {
  Rows rows(run);
  constexpr int rows_looked_at = 512, beside = 64;  // px on either side of the edge
  for (const int canvas : {1024, 4096, 16384}) {
    Random random(run.seed);
    double naive = 0, robust = 0, edge_pixels = 0;
    const int triangles = run.count(200 * 4096 / canvas, 24);
    for (int i = 0; i < triangles; ++i) {
      run.check();
      const auto any = [&] { return static_cast<float>(random.between(0, canvas)); };
      Corners p;
      for (Vec2f& corner : p) corner = {any(), any()};
      const int x0 = static_cast<int>(std::min({p[0].x, p[1].x, p[2].x}));
      const int y0 = static_cast<int>(std::min({p[0].y, p[1].y, p[2].y}));
      const auto centre = [](int pixel) { return static_cast<float>(pixel) + 0.5f; };
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec2f a = p[k], b = p[(k + 1) % 3], along = b - a;
        const Vec2d from(a), exact(Vec2d(b) - from);
        if (std::abs(along.y) < 1) continue;
        const auto truth_at = [&](double x, double y) { return exact.x * (y - from.y) - exact.y * (x - from.x); };
        float row_value = relative_value(a, b, {centre(x0), centre(y0)});
        for (int y = y0; y < static_cast<int>(std::max(a.y, b.y)); ++y, row_value += along.x) {
          if (y % (canvas / rows_looked_at) != 0 || static_cast<float>(y) < std::min(a.y, b.y)) continue;
          edge_pixels += 1 + std::abs(exact.x / exact.y);
          const double crossing = from.x + exact.x * (y + 0.5 - from.y) / exact.y;
          float value = row_value;
          const int last = std::min(canvas, static_cast<int>(crossing) + beside);
          for (int x = x0; x < last; ++x, value -= along.y) {
            if (x < crossing - beside) continue;
            const bool truth = truth_at(x + 0.5, y + 0.5) > 0;
            naive += (value > 0) != truth ? 1 : 0;
            robust += (relative_value(a, b, {centre(x), centre(y)}) > 0) != truth ? 1 : 0;
          }
        }
      }
    }
    rows.push_back({static_cast<double>(canvas), "triangles on the canvas", naive / edge_pixels, robust / edge_pixels,
                    "wrong px per edge px"});
  }
  return rows;
}

}  // namespace

const StabilityExperiment fill_rule_adversarial{
    .key = "fill-rule-adversarial",
    .title = "Edges through a sample",
    .knob = "length of the edge (px)",
    .naive = "edge functions in float",
    .robust = "corners in one order for both triangles, or 64-bit integers",
    .explanation =
        "Two triangles start the same edge at different ends, so a sample within rounding of it may lie "
        "outside both or inside both. Random meshes hardly ever show it, whatever the method; edges have to be aimed.",
    .safe = "Nowhere for edges that pass a sample within an ulp.",
    .window = nowhere_safe,
    .measure = measure_adversarial};

const StabilityExperiment stepped_edge_drift{
    .key = "stepped-edge-drift",
    .title = "Stepped edges drift",
    .knob = "side of the canvas (px)",
    .naive = "float, one addition a sample",
    .robust = "float, each sample afresh",
    .explanation = "An edge value near zero is what is left of many additions to a large one, and each of them was "
                   "rounded to the spacing of the large one. The error grows with the square of the canvas.",
    .safe = "Canvases up to 1,000 pixels for one pixel in a thousand.",
    .window = {nowhere, 1024},
    .measure = measure_drift};

}  // namespace ps::stability
