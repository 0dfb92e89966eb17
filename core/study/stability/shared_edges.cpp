#include "raster/edge_function.h"
#include "study/stability/support.h"

#include <array>

namespace ps::stability {
namespace {

using Corners = std::array<Vec2f, 3>;

/// Does an edge from a to b own the samples on it? Rows grow downwards.
bool owned(const Vec2f& a, const Vec2f& b) { return b.y - a.y < 0 || (b.y == a.y && b.x > a.x); }
bool inside(float value, const Vec2f& a, const Vec2f& b) { return value > 0 || (value == 0 && owned(a, b)); }

/// Calls edge(a, b) for the three edges in the triangle's own order, turned so that inside is positive.
template <class Edge>
bool all_edges(Corners p, Edge&& edge) {
  const Vec2f u = p[1] - p[0], v = p[2] - p[0];
  if (u.x * v.y - u.y * v.x < 0) std::swap(p[1], p[2]);
  return edge(p[0], p[1]) && edge(p[1], p[2]) && edge(p[2], p[0]);
}

float relative_value(const Vec2f& a, const Vec2f& b, const Vec2f& s) {
  return (b.x - a.x) * (s.y - a.y) - (b.y - a.y) * (s.x - a.x);
}

bool covers_relative(const Corners& p, const Vec2f& s) {
  return all_edges(p, [&](const Vec2f& a, const Vec2f& b) { return inside(relative_value(a, b, s), a, b); });
}
bool covers_canonical(const Corners& p, const Vec2f& s) {
  return all_edges(p, [&](const Vec2f& a, const Vec2f& b) {
    const bool turn = b.x < a.x || (b.x == a.x && b.y < a.y);
    return inside(turn ? -relative_value(b, a, s) : relative_value(a, b, s), a, b);
  });
}
/// A x + B y + C: the same numbers for both triangles, so consistent, but C is large far from the origin.
bool covers_absolute(const Corners& p, const Vec2f& s) {
  return all_edges(p, [&](const Vec2f& a, const Vec2f& b) {
    const float A = a.y - b.y, B = b.x - a.x, C = a.x * b.y - a.y * b.x;
    return inside(A * s.x + B * s.y + C, a, b);
  });
}
/// From the triangle's box to the sample by additions.
bool covers_stepped(const Corners& p, const Vec2f& s) {
  const float x0 = std::floor(std::min({p[0].x, p[1].x, p[2].x})) + 0.5f;
  const float y0 = std::floor(std::min({p[0].y, p[1].y, p[2].y})) + 0.5f;
  return all_edges(p, [&](const Vec2f& a, const Vec2f& b) {
    float value = relative_value(a, b, {x0, y0});
    const float dx = b.x - a.x, dy = b.y - a.y;
    for (float y = y0; y < s.y; y += 1) value += dx;
    for (float x = x0; x < s.x; x += 1) value -= dy;
    return inside(value, a, b);
  });
}
bool covers_fixed(const Corners& p, const Vec2f& s) {
  const raster::CoverageGrid grid{8, FillRule::top_left, {0.5, 0.5}};
  const auto edges =
      raster::make_edges({raster::to_fixed(p[0], 8), raster::to_fixed(p[1], 8), raster::to_fixed(p[2], 8)}, grid);
  return edges && edges->inside(edges->at(static_cast<int>(s.x), static_cast<int>(s.y)));
}

using Covers = bool (*)(const Corners&, const Vec2f&);
struct Tally {
  double holes = 0, doubles = 0;  ///< per million edges
};

/// Two triangles on both sides of an edge that passes within an ulp of a sample.
Tally aim_edges(float length, float offset, Covers covers, const StabilityRun& run) {
  run.check();
  Random random(run.seed);
  Tally tally;
  const int edges = run.count(200000, 20000);
  for (int trial = 0; trial < edges; ++trial) {
    const auto place = [&] { return offset + std::floor(static_cast<float>(random.between(0, 600))) + 0.5f; };
    const Vec2f sample(place(), place());
    const float angle = static_cast<float>(random.between(0, 2 * pi));
    const Vec2f along(std::cos(angle), std::sin(angle)), across(-along.y, along.x);
    const float split = static_cast<float>(random.between(0.1, 0.9));
    const Vec2f a = sample - along * (length * split);
    Vec2f b = sample + along * (length * (1 - split));
    const int nudge = trial % 3 - 1;
    if (nudge != 0) b.x = std::nextafter(b.x, nudge > 0 ? 1e9f : -1e9f);
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

std::vector<StabilityRow> measure_adversarial(const StabilityRun& run) {
  struct Method {
    const char* name;
    Covers naive, robust;
  };
  Rows rows(run);
  for (const Method& method : {Method{"float, own order", covers_relative, covers_canonical},
                               Method{"float, stepped", covers_stepped, covers_fixed},
                               Method{"float, A x + B y + C", covers_absolute, covers_fixed}})
    for (const float length : {10.0f, 100.0f, 1000.0f}) {
      const Tally naive = aim_edges(length, 0, method.naive, run), robust = aim_edges(length, 0, method.robust, run);
      rows.push_back({length, std::string(method.name) + ", holes", naive.holes, robust.holes, "per million edges"});
      rows.push_back(
          {length, std::string(method.name) + ", doubles", naive.doubles, robust.doubles, "per million edges"});
    }
  const Tally far = aim_edges(10, 16000, covers_absolute, run), fixed = aim_edges(10, 16000, covers_fixed, run);
  rows.push_back({10, "float, A x + B y + C at 16,000 px, holes", far.holes, fixed.holes, "per million edges"});
  rows.push_back({10, "float, A x + B y + C at 16,000 px, doubles", far.doubles, fixed.doubles, "per million edges"});
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
    .explanation = "Two triangles start the same edge at different ends, so a sample within rounding of it may lie "
                   "outside both or inside both. Random meshes never show it; edges have to be aimed.",
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
