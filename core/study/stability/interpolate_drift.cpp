#include <algorithm>
#include <array>
#include <cmath>

#include "study/stability/support.h"

namespace ps::stability {
namespace {

constexpr std::array lengths{100, 600, 1000, 10000, 100000, 1000000};

/// The value after k of n steps from the ends alone.
template <class Real>
Real between_ends(Real first, Real last, int k, int n) {
  return first + (last - first) * (static_cast<Real>(k) / static_cast<Real>(n));
}

/// The book's Interpolate (CGFS ch. 6) adds a slope again and again. A steep edge near canvas position 512, where
/// floats are 2^-14 px apart: its slope of 4.4944 such steps is rounded down at every addition, and no end of it is a
/// float. Sums are looked at where they are worst, at their end; values from the ends after every step.
void add_slopes(Rows& rows) {
  constexpr double step = (4.5 - 1 / 180.0) * 0x1p-14;
  for (const int n : lengths) {
    const double truth = 512 + step * n;
    const float start = 512, end = static_cast<float>(truth);
    float added = start;
    double worst = 0;
    for (int i = 1; i <= n; ++i) {
      added += static_cast<float>(step);
      const float direct = between_ends(start, end, i, n);
      worst = std::max(worst, std::abs(static_cast<double>(direct) - (512 + step * i)));
    }
    rows.push_back({static_cast<double>(n), "float", std::abs(static_cast<double>(added) - truth), worst,
                    "px at the end of the edge"});
  }
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

/// How many of an edge's pixels are another one when the value is rounded to whole pixels.
void count_wrong_pixels(Rows& rows, const StabilityRun& run) {
  for (const int n : {100, 600, 1000, 10000, 100000}) {
    double naive = 0, robust = 0, steps = 0;
    for (const Edge& edge : any_edges(run.count(std::clamp(20000000 / n, 100, 20000), 20), run)) {
      const auto start = static_cast<float>(edge.first), end = static_cast<float>(edge.last);
      const double from = static_cast<double>(start), slope = (static_cast<double>(end) - from) / n;
      const float rounded_slope = (end - start) / static_cast<float>(n);
      float added = start;
      for (int i = 1; i <= n; ++i) {
        added += rounded_slope;
        const double truth = std::floor(from + slope * i + 0.5);
        naive += std::floor(static_cast<double>(added) + 0.5) != truth ? 1 : 0;
        robust += std::floor(static_cast<double>(between_ends(start, end, i, n)) + 0.5) != truth ? 1 : 0;
      }
      steps += n;
    }
    rows.push_back({static_cast<double>(n), "float, edges anywhere", percent(naive, steps), percent(robust, steps),
                    "% of steps at another pixel"});
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
      double added = edge.first;
      const double slope = (edge.last - edge.first) / n;
      for (int i = 0; i < n && n <= 100000; ++i) added += slope;
      naive = std::max(naive, std::abs(added - edge.last));
      robust = std::max(robust, std::abs(between_ends(edge.first, edge.last, n, n) - edge.last));
      const std::int64_t start = sixteen(edge.first), end = sixteen(edge.last), fixed_slope = sixteen(slope);
      std::int64_t sum = start;
      for (int i = 0; i < n; ++i) sum += fixed_slope;
      fixed = std::max(fixed, std::abs(from_sixteen(sum) - edge.last));
      fixed_robust = std::max(fixed_robust, std::abs(from_sixteen(start + (end - start) * n / n) - edge.last));
    }
    if (n <= 100000)  // longer ones cost half a second
      rows.push_back({static_cast<double>(n), "double, worst of 64 edges", naive, robust, "px at the end of the edge"});
    rows.push_back({static_cast<double>(n), "16.16 fixed point, worst of 64 edges", fixed, fixed_robust,
                    "px at the end of the edge"});
  }
}

/// 1 / z from 1 at z = 1 to 0.001 at z = 1000: what is left of it at the end is small against what was added up.
void add_inverse_depths(Rows& rows) {
  for (const int n : {100, 600, 2000}) {
    const float first = 1, last = 0.001f;
    const float slope = (last - first) / static_cast<float>(n);
    float added = first;
    for (int i = 0; i < n; ++i) added += slope;
    const auto error = [&](float inverse) {
      return 100 * std::abs(static_cast<double>(last) / static_cast<double>(inverse) - 1);
    };
    rows.push_back({static_cast<double>(n), "float 1/z from 1 to 0.001", error(added),
                    error(between_ends(first, last, n, n)), "% of z at the end"});
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
    rows.push_back({static_cast<double>(turns), "float, turned by 1 degree each step",
                    std::hypot(static_cast<double>(x), static_cast<double>(y)) - 1, static_cast<double>(afresh) - 1,
                    "length gained"});
  }
}

std::vector<StabilityRow> measure(const StabilityRun& run) {
  Rows rows(run);
  add_slopes(rows);
  count_wrong_pixels(rows, run);
  finer_numbers(rows, run);
  add_inverse_depths(rows);
  turn_again_and_again(rows);
  return rows;
}

}  // namespace

const StabilityExperiment interpolate_drift{.key = "interpolate-drift",
                                            .title = "Interpolate drifts",
                                            .knob = "steps",
                                            .naive = "d += slope",
                                            .robust = "each value from the ends",
                                            .explanation =
                                                "Every addition rounds, and a constant slope rounds the same way each "
                                                "time. A value computed from the ends has one rounding only.",
                                            .safe = "Up to about 10,000 steps for a third of a pixel.",
                                            .window = {nowhere, 10000},
                                            .measure = measure};

}  // namespace ps::stability
