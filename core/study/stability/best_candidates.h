#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "study/stability/support.h"

namespace ps::stability {

/// Points of which each is the farthest from all before of a number of candidates that grows with theirs (Mitchell
/// 1991); the square's sides are neighbours. Any number of the first ones is such a set too.
class BestCandidates {
 public:
  BestCandidates(int count, Random& random) {
    for (int i = 0; i < count; ++i) {
      Vec2d best(0);
      double farthest = -1;
      for (int candidate = 0; candidate <= i; ++candidate) {
        const Vec2d place(random.unit(), random.unit());
        const double away = distance2(place, farthest);
        if (away > farthest) farthest = away, best = place;
      }
      cells_[cell(best.y) * side + cell(best.x)].push_back(best);
      points_.push_back(best);
    }
  }
  const std::vector<Vec2d>& points() const { return points_; }

 private:
  static constexpr std::size_t side = 16;
  static std::size_t cell(double v) { return std::min(side - 1, static_cast<std::size_t>(v * side)); }

  /// To the nearest point, squared; less where it cannot be more than `enough`.
  double distance2(const Vec2d& place, double enough) const {
    double least = 2;
    const std::size_t x = cell(place.x), y = cell(place.y);
    for (std::size_t ring = 0; ring <= side / 2; ++ring) {
      // Nothing in this ring or farther out is nearer than the cells between.
      const double between = ring > 0 ? (static_cast<double>(ring) - 1) / side : 0;
      if (between * between > least || least <= enough) break;
      for (std::size_t j = 0; j <= 2 * ring; ++j)
        for (std::size_t i = 0; i <= 2 * ring; i += j == 0 || j == 2 * ring || ring == 0 ? 1 : 2 * ring)
          for (const Vec2d& p : cells_[(y + side + j - ring) % side * side + (x + side + i - ring) % side]) {
            const double dx = std::remainder(p.x - place.x, 1), dy = std::remainder(p.y - place.y, 1);
            least = std::min(least, dx * dx + dy * dy);
          }
    }
    return least;
  }

  std::array<std::vector<Vec2d>, side * side> cells_;
  std::vector<Vec2d> points_;
};

}  // namespace ps::stability
