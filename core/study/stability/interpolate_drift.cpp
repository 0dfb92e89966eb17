#include <algorithm>
#include <array>
#include <cmath>

#include "raster/clear/interpolate.h"
#include "study/stability/support.h"

namespace ps::stability::interpolate_drift {
namespace {

constexpr std::array lengths{100, 600, 1000, 10000, 100000, 1000000};

/// The value after k of n steps from the ends alone.
template <class Real>
Real between_ends(Real first, Real last, int k, int n) {
  return first + (last - first) * (static_cast<Real>(k) / static_cast<Real>(n));
}

struct Edge {
  double first = 0, last = 0;  ///< canvas positions, px
};

/// Edges from anywhere to anywhere on a canvas of 1,024 px.
std::vector<Edge> any_edges(int count, const StabilityRun& run) {
  Random random(run.seed);
  std::vector<Edge> edges(static_cast<std::size_t>(count));
  for (Edge& edge : edges) {
    edge.first = random.between(0, 1024);
    edge.last = random.between(0, 1024);
  }
  return edges;
}

/// What the program's Interpolate (raster/clear/interpolate.h), which adds the slope again and again, has at the end of
/// an edge of n steps.
template <class Real>
Real added_up(Real first, Real last, int n) {
  return raster::InterpolatedValues<Real>(0, first, static_cast<Real>(n), last).at(n);
}

/// Largest errors over 64 edges: of sums at their end, where they are worst, and of values from the ends at any step.
void add_slopes(Rows& rows, const StabilityRun& run) {
  const std::vector<Edge> edges = any_edges(64, run);
  for (const int n : lengths) {
    run.check();
    double naive = 0, robust = 0;
    for (const Edge& edge : edges) {
      const auto start = static_cast<float>(edge.first), end = static_cast<float>(edge.last);
      const double from = static_cast<double>(start), slope = (static_cast<double>(end) - from) / n;
      naive = std::max(naive, std::abs(static_cast<double>(added_up(start, end, n) - end)));
      for (int i = 1; i <= n; i += std::max(1, n / 10000))
        robust = std::max(robust, std::abs(static_cast<double>(between_ends(start, end, i, n)) - (from + slope * i)));
    }
    rows.add(n, "float, worst of 64 edges", naive, robust, "px at the end of the edge");
  }
}

/// How many of an edge's pixels are another one when the value is rounded to whole pixels.
void count_wrong_pixels(Rows& rows, const StabilityRun& run) {
  for (const int n : {100, 600, 1000, 10000, 100000}) {
    double naive = 0, robust = 0, steps = 0;
    for (const Edge& edge : any_edges(run.count(std::clamp(16000000 / n, 100, 20000), 20), run)) {
      const auto start = static_cast<float>(edge.first), end = static_cast<float>(edge.last);
      const double from = static_cast<double>(start), slope = (static_cast<double>(end) - from) / n;
      raster::InterpolatedValues<float> added(0, start, static_cast<float>(n), end);
      for (int i = 1; i <= n; ++i) {
        const double truth = std::floor(from + slope * i + 0.5);
        naive += std::floor(static_cast<double>(added.at(i)) + 0.5) != truth ? 1 : 0;
        robust += std::floor(static_cast<double>(between_ends(start, end, i, n)) + 0.5) != truth ? 1 : 0;
      }
      steps += n;
    }
    rows.add(n, "float, edges anywhere", percent(naive, steps), percent(robust, steps), "% of steps at another pixel");
  }
}

/// Numbers with 16 bits after the point.
std::int64_t sixteen(double value) { return std::llround(value * 65536); }
double from_sixteen(std::int64_t value) { return static_cast<double>(value) / 65536; }

/// The largest error at the end of 64 edges.
void finer_numbers(Rows& rows, const StabilityRun& run) {
  const std::vector<Edge> edges = any_edges(64, run);
  for (const int n : lengths) {
    double naive = 0, robust = 0, fixed = 0, fixed_robust = 0;
    for (const Edge& edge : edges) {
      run.check();
      if (n <= 100000) naive = std::max(naive, std::abs(added_up(edge.first, edge.last, n) - edge.last));
      robust = std::max(robust, std::abs(between_ends(edge.first, edge.last, n, n) - edge.last));
      const std::int64_t start = sixteen(edge.first), end = sixteen(edge.last),
                         fixed_slope = sixteen((edge.last - edge.first) / n);
      std::int64_t sum = start;
      for (int i = 0; i < n; ++i) sum += fixed_slope;
      fixed = std::max(fixed, std::abs(from_sixteen(sum) - edge.last));
      fixed_robust = std::max(fixed_robust, std::abs(from_sixteen(start + (end - start) * n / n) - edge.last));
    }
    if (n <= 100000)  // longer ones cost half a second
      rows.add(n, "double, worst of 64 edges", naive, robust, "px at the end of the edge");
    rows.add(n, "16.16 fixed point, worst of 64 edges", fixed, fixed_robust, "px at the end of the edge");
  }
}

/// 1 / z from 1 at z = 1 to 0.001 at z = 1000: what is left of it at the end is small against what was added up.
void add_inverse_depths(Rows& rows) {
  for (const int n : {100, 600, 2000}) {
    const float first = 1, last = 0.001f;
    const auto error = [&](float inverse) {
      return 100 * std::abs(static_cast<double>(last) / static_cast<double>(inverse) - 1);
    };
    rows.add(n, "float 1/z from 1 to 0.001", error(added_up(first, last, n)), error(between_ends(first, last, n, n)),
             "% of z at the end");
  }
}

/// A direction turned by 1 degree again and again, by products of floats, or from the whole angle each time.
void turn_again_and_again(Rows& rows) {
  constexpr double degree = pi / 180;
  const auto cosine = static_cast<float>(std::cos(degree)), sine = static_cast<float>(std::sin(degree));
  float x = 1, y = 0;
  int turns = 0;
  for (const int last : {3600, 36000, 360000, 3600000}) {
    for (; turns < last; ++turns) {
      const float turned = cosine * x - sine * y;
      y = sine * x + cosine * y;
      x = turned;
    }
    const double angle = std::fmod(turns * degree, 2 * pi);
    const auto afresh = std::hypot(static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle)));
    rows.add(turns, "float, turned by 1 degree each step",
             std::hypot(static_cast<double>(x), static_cast<double>(y)) - 1, static_cast<double>(afresh) - 1,
             "length gained");
  }
}

void measure(const StabilityRun& run, Rows& rows) {
  add_slopes(rows, run);
  count_wrong_pixels(rows, run);
  finer_numbers(rows, run);
  add_inverse_depths(rows);
  turn_again_and_again(rows);
}

}  // namespace

extern const StabilityExperiment interpolate_drift{
    .key = "interpolate-drift",
    .place = {Subject::depth, 10},
    .set_up = SetUp::reproduction,
    .title = "Incremental error: Interpolate drifts",
    .keywords = "DDA, accumulated error, incremental, rounding",
    .knob = "steps",
    .naive = "d += slope (the book's Interpolate)",
    .robust = "each value from the ends",
    .explanation =
        "Every addition rounds, and a constant slope is rounded the same way again and again. A value computed from "
        "the ends is rounded only once or twice.",
    .safe = "Up to about 10,000 steps for a third of a pixel.",
    .window = {nowhere, 10000},
    .series = {{.names = "float, worst of 64 edges|*", .title = "error at the end of the edge", .unit = "px"},
               {.names = "float, edges anywhere", .title = "steps that land on another pixel", .unit = "%"},
               {.names = "float 1/z*", .title = "error of z at the end", .unit = "%"},
               {.names = "float, turned*", .title = "length gained by a vector that is turned", .unit = "lengths"}},
    .add_rows = measure};

}  // namespace ps::stability::interpolate_drift
