#include <array>

#include "study/stability/support.h"

namespace ps::stability {
namespace {

struct Ball {
  Vec3d centre;
  double radius;
  Vec3d low() const { return centre - radius; }
  Vec3d high() const { return centre + radius; }
  /// Infinite without a hit.
  double hit(const Vec3d& origin, const Vec3d& direction) const {
    const Vec3d f = origin - centre;
    const double a = dot(direction, direction), b = dot(f, direction);
    const double discriminant = b * b - a * (dot(f, f) - radius * radius);
    if (!(discriminant >= 0)) return everywhere;
    const double t = (-b - std::sqrt(discriminant)) / a;
    return t > 0 ? t : everywhere;
  }
};

/// A rectangle across an axis: flat there.
struct Quad {
  int axis;
  Vec3d corner, opposite;
  Vec3d centre = (corner + opposite) * 0.5;
  Vec3d low() const { return corner; }
  Vec3d high() const { return opposite; }
  double hit(const Vec3d& origin, const Vec3d& direction) const {
    const double t = (corner[axis] - origin[axis]) / direction[axis];
    if (!(t > 0)) return everywhere;
    for (int k = 1; k < 3; ++k) {
      const int along = (axis + k) % 3;
      const double place = origin[along] + t * direction[along];
      if (!(place >= corner[along] && place <= opposite[along])) return everywhere;
    }
    return t;
  }
};

/// How a grid keeps and searches its balls.
enum class Way {
  centres_only,     ///< a ball stands in the cell of its centre alone
  mailbox_rejects,  ///< stands in all it touches, is tested once, and counts only if hit inside that cell
  first_hit_wins,   ///< as above without the mailbox's flaw, but the first cell with a hit ends the walk
  retest,           ///< stands in all it touches, is tested in each, and counts only if hit inside that cell
  keep_best         ///< the walk ends when the best hit lies before the end of the cell
};

/// A uniform grid over the unit cube.
template <class Shape>
class Grid {
 public:
  Grid(const std::vector<Shape>& shapes, int side, bool centres_only) : side_(side), cells_(index(0, 0, side)) {
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      const Vec3d from = centres_only ? shapes[i].centre : shapes[i].low();
      const Vec3d to = centres_only ? shapes[i].centre : shapes[i].high();
      std::array<int, 3> low{}, high{};
      for (int axis = 0; axis < 3; ++axis) {
        low[static_cast<std::size_t>(axis)] = cell_of(from[axis]);
        high[static_cast<std::size_t>(axis)] = cell_of(to[axis]);
      }
      for (int z = low[2]; z <= high[2]; ++z)
        for (int y = low[1]; y <= high[1]; ++y)
          for (int x = low[0]; x <= high[0]; ++x) cells_[index(x, y, z)].push_back(static_cast<int>(i));
    }
  }

  /// The shape that the ray is said to meet first, or -1. The origin lies outside the cube, the ray goes through it.
  int search(const std::vector<Shape>& shapes, const Vec3d& origin, const Vec3d& direction, Way way) const {
    double enter = 0, leave = everywhere;
    for (int axis = 0; axis < 3; ++axis) {
      const double a = -origin[axis] / direction[axis], b = (1 - origin[axis]) / direction[axis];
      enter = std::max(enter, std::min(a, b));
      leave = std::min(leave, std::max(a, b));
    }
    if (!(enter <= leave)) return -1;
    std::array<int, 3> cell{}, step{};
    std::array<double, 3> next{}, width{};
    const Vec3d start = origin + direction * enter;
    for (int axis = 0; axis < 3; ++axis) {
      const auto i = static_cast<std::size_t>(axis);
      cell[i] = cell_of(start[axis]);
      step[i] = direction[axis] < 0 ? -1 : 1;
      width[i] = std::abs(1 / (side_ * direction[axis]));
      const double plane = static_cast<double>(cell[i] + (step[i] > 0 ? 1 : 0)) / side_;
      next[i] = (plane - origin[axis]) / direction[axis];
    }
    std::vector<char> tested(shapes.size(), 0);
    int best = -1;
    double best_t = everywhere;
    while (true) {
      const std::size_t axis = next[0] < next[1] ? (next[0] < next[2] ? 0 : 2) : (next[1] < next[2] ? 1 : 2);
      const double exit = next[axis];
      for (const int i : cells_[index(cell[0], cell[1], cell[2])]) {
        if (way == Way::mailbox_rejects && tested[static_cast<std::size_t>(i)]) continue;
        tested[static_cast<std::size_t>(i)] = 1;
        const double t = shapes[static_cast<std::size_t>(i)].hit(origin, direction);
        if ((way == Way::mailbox_rejects || way == Way::retest) && !(t <= exit)) continue;
        if (t < best_t) best_t = t, best = i;
      }
      if (best >= 0 && (way == Way::keep_best ? best_t <= exit : true)) return best;
      cell[axis] += step[axis];
      if (cell[axis] < 0 || cell[axis] >= side_) return best;
      next[axis] += width[axis];
    }
  }

 private:
  /// Of the cell (x, y, z) in `cells_`; that of (0, 0, side) is the number of cells.
  std::size_t index(int x, int y, int z) const {
    const auto side = static_cast<std::size_t>(side_);
    return (static_cast<std::size_t>(z) * side + static_cast<std::size_t>(y)) * side + static_cast<std::size_t>(x);
  }
  int cell_of(double place) const { return std::clamp(static_cast<int>(std::floor(place * side_)), 0, side_ - 1); }
  int side_;
  std::vector<std::vector<int>> cells_;
};

/// Where rays start, before they go through evenly spread points of the cube.
enum class From {
  all_around,  ///< 2 away from its middle
  one_side     ///< 1 before the face at z = 0, so that along z all of them go up
};

/// A ray of length 1. What a walk adds up is rounded at each cell unless its numbers are round.
std::pair<Vec3d, Vec3d> next_ray(From from, Random& random) {
  const Vec3d origin =
      from == From::all_around ? Vec3d(0.5) + random.direction() * 2.0 : Vec3d(random.unit(), random.unit(), -1);
  const Vec3d direction = Vec3d(random.unit(), random.unit(), random.unit()) - origin;
  return {origin, direction / std::sqrt(dot(direction, direction))};
}

/// Percentage of hits that each way misses or takes for another, in the order of Way.
template <class Shape>
std::array<double, 5> wrong_of(const std::vector<Shape>& shapes, int side, std::initializer_list<Way> ways, From from,
                               Random& random, const StabilityRun& run) {
  run.check();
  const Grid<Shape> overlapping(shapes, side, false), centres(shapes, side, true);
  std::array<double, 5> wrong{};
  double hits = 0;
  const int rays = run.count(20000, 3000);
  for (int i = 0; i < rays; ++i) {
    const auto [origin, direction] = next_ray(from, random);
    int truth = -1;
    double nearest = everywhere;
    for (std::size_t k = 0; k < shapes.size(); ++k) {
      const double t = shapes[k].hit(origin, direction);
      if (t < nearest) nearest = t, truth = static_cast<int>(k);
    }
    if (truth < 0) continue;
    ++hits;
    for (const Way way : ways) {
      const Grid<Shape>& grid = way == Way::centres_only ? centres : overlapping;
      const Way walk = way == Way::centres_only ? Way::keep_best : way;
      const int found = grid.search(shapes, origin, direction, walk);
      // Two quads of one plane may be met at the same t.
      const bool right = found >= 0 && shapes[static_cast<std::size_t>(found)].hit(origin, direction) <= nearest;
      wrong[static_cast<std::size_t>(way)] += right ? 0 : 1;
    }
  }
  for (double& count : wrong) count = percent(count, hits);
  return wrong;
}

std::vector<Ball> balls_in_cube(Random& random) {
  std::vector<Ball> balls;
  for (int i = 0; i < 2000; ++i) {
    // Radii of 0.02 to 0.05 in a unit cube; the grid is the cube around them all.
    constexpr double scale = 1 / 1.1, low = 0.05 * scale, high = 1 - low;
    const double radius = scale * random.between(0.02, 0.05);
    balls.push_back({{random.between(low, high), random.between(low, high), random.between(low, high)}, radius});
  }
  return balls;
}

/// 2,000 rectangles with sides of 0.04 to 0.1 in planes at sixteenths, which are borders of cells at 16 and 64: they
/// stand in the cells above their plane.
std::vector<Quad> quads_on_borders(Random& random) {
  std::vector<Quad> quads;
  for (int i = 0; i < 2000; ++i) {
    const int axis = static_cast<int>(random.below(3));
    Vec3d corner(static_cast<double>(random.below(17)) / 16), opposite = corner;
    for (int k = 1; k < 3; ++k) {
      const int along = (axis + k) % 3;
      const double width = random.between(0.04, 0.1);
      corner[along] = random.between(0, 1 - width);
      opposite[along] = corner[along] + width;
    }
    quads.push_back({axis, corner, opposite});
  }
  return quads;
}

std::vector<StabilityRow> measure(const StabilityRun& run) {
  Rows rows(run);
  for (const int side : {4, 16, 64}) {
    Random random(run.seed);
    const auto balls = balls_in_cube(random);
    const auto wrong = wrong_of(
        balls, side, {Way::centres_only, Way::mailbox_rejects, Way::first_hit_wins, Way::retest, Way::keep_best},
        From::all_around, random, run);
    const char* names[] = {"centres alone", "mailbox and t <= cell exit", "first hit wins",
                           "t <= cell exit, tested in each cell"};
    for (std::size_t i = 0; i < 4; ++i)
      rows.push_back({static_cast<double>(side), names[i], wrong[i], wrong[4], "% of hits missed or wrong"});
    const auto quads = quads_on_borders(random);
    const auto flat =
        wrong_of(quads, side, {Way::centres_only, Way::retest, Way::keep_best}, From::one_side, random, run);
    for (const std::size_t i : {0u, 3u})
      rows.push_back({static_cast<double>(side), std::string("quads on borders, ") + names[i], flat[i], flat[4],
                      "% of hits missed or wrong"});
  }
  return rows;
}

}  // namespace

const StabilityExperiment grid_octree_borders{
    .key = "grid-octree-borders",
    .title = "Borders of grids and octrees",
    .knob = "cells along a side",
    .naive = "short cuts of registration and search",
    .robust = "stand in every cell touched, keep the best until it lies before the cell's end",
    .explanation =
        "A ball that reaches into other cells is not found there, or is found in one cell and hit in another. "
        "What decides is where the hit lies, not in which cell the test was made.",
    .safe = "Nowhere.",
    .window = nowhere_safe,
    .measure = measure};

}  // namespace ps::stability
