#include <algorithm>
#include <cmath>

#include "raster/interpolate.h"
#include "study/stability/support.h"

namespace ps::stability {

namespace {

using raster::InterpolatedValues;

/// An edge from depth 1 to depth r, looked at along its whole length on the screen: z mixed as it is against 1/z mixed.
void largest_errors(Rows& rows, const StabilityRun& run) {
  constexpr int places = 100000;
  for (const double ratio : {1.1, 2.0, 5.0, 10.0, 100.0, 1000.0}) {
    run.check();
    double naive = 0, robust = 0;
    for (int i = 0; i <= places; ++i) {
      const double s = static_cast<double>(i) / places;  // share of the way on the screen
      // The point of the edge seen there: depth d with (d - 1) / (ratio - 1) * ratio / d = s.
      const double truth = ratio / (ratio - s * (ratio - 1));
      const double z = 1 + s * (ratio - 1);
      const double from_inverse = 1 / (1 + s * (1 / ratio - 1));
      naive = std::max(naive, std::abs(z - truth) / (ratio - 1));
      robust = std::max(robust, std::abs(from_inverse - truth) / (ratio - 1));
    }
    rows.push_back({ratio, "largest on the edge", naive, robust, "share of the depth range"});
  }
}

/// The edge from A(-1, 0, 2) to B(1, 0, 10) of the book's chapter on hidden surfaces (CGFS ch. 12), which a canvas of
/// 600 px before a camera with d = 1 shows from x = -300 to x = 60.
struct BookEdge {
  static constexpr double near = 2, far = 10;
  static constexpr int first = -300, last = 60;
  static double mixed(int x) { return InterpolatedValues<double>(first, near, last, far).at(x - first); }
  static double from_inverse(int x) {
    return 1 / InterpolatedValues<double>(first, 1 / near, last, 1 / far).at(x - first);
  }
  /// Where the ray through (x / 600, 1) meets the line x = (z - 6) / 4.
  static double truth(int x) { return 6 / (1 - 4 * x / 600.0); }
};

/// Its depth in the middle of the canvas, and how often it wins or loses wrongly against something of one depth, for
/// all depths between its ends.
void book_edge(Rows& rows) {
  constexpr int objects = 1000;
  constexpr double ratio = BookEdge::far / BookEdge::near;
  rows.push_back(
      {ratio, "the book's edge", BookEdge::mixed(0), BookEdge::from_inverse(0), "z in the middle of the canvas"});
  double naive = 0, robust = 0, all = 0;
  for (int x = BookEdge::first; x <= BookEdge::last; ++x) {
    const double truth = BookEdge::truth(x), mixed = BookEdge::mixed(x), from_inverse = BookEdge::from_inverse(x);
    for (int i = 0; i < objects; ++i) {
      const double z = BookEdge::near + (BookEdge::far - BookEdge::near) * (i + 0.5) / objects;
      naive += (mixed < z) != (truth < z) ? 1 : 0;
      robust += (from_inverse < z) != (truth < z) ? 1 : 0;
      ++all;
    }
  }
  rows.push_back({ratio, "the book's edge before objects of one depth", percent(naive, all), percent(robust, all),
                  "% of pixels that show the wrong one"});
}

std::vector<StabilityRow> measure_inverse_depth(const StabilityRun& run) {
  Rows rows(run);
  largest_errors(rows, run);
  book_edge(rows);
  return rows;
}

}  // namespace

const StabilityExperiment inverse_depth{
    .key = "z-vs-1-z",
    .title = "z against 1/z",
    .knob = "ratio of the depths of the ends",
    .naive = "mix z",
    .robust = "mix 1/z",
    .explanation = "Equal steps on the screen are not equal steps in depth. 1/z is linear on the screen, z is not.",
    .safe = "Ratios up to 1.1 for an error of 2.5 %.",
    .window = {nowhere, 1.1},
    .measure = measure_inverse_depth};

}  // namespace ps::stability
