#include "study/stability/sampling_rates.h"

#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "raytrace/sampling/pattern.h"
#include "study/stability/best_candidates.h"
#include "study/stability/n_rooks.h"

namespace ps::stability {

double area_below(const Edge& edge) {
  const std::array<Vec2d, 4> corner{Vec2d(0, 0), {1, 0}, {1, 1}, {0, 1}};
  std::vector<Vec2d> kept;
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec2d &a = corner[i], &b = corner[(i + 1) % 4];
    const double da = edge.normal.x * a.x + edge.normal.y * a.y - edge.offset;
    const double db = edge.normal.x * b.x + edge.normal.y * b.y - edge.offset;
    if (da <= 0) kept.push_back(a);
    if ((da < 0) != (db < 0)) kept.push_back(a + (b - a) * (da / (da - db)));
  }
  double twice = 0;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    const Vec2d &a = kept[i], &b = kept[(i + 1) % kept.size()];
    twice += a.x * b.y - a.y * b.x;
  }
  return std::abs(twice) / 2;
}

double rate(const RateErrors& errors) {
  double mean_x = 0, mean_y = 0, up = 0, down = 0;
  for (std::size_t i = 0; i < 4; ++i) mean_x += std::log(rate_counts[i]) / 4, mean_y += std::log(errors[i]) / 4;
  for (std::size_t i = 0; i < 4; ++i) {
    const double x = std::log(rate_counts[i]) - mean_x;
    up += x * (std::log(errors[i]) - mean_y);
    down += x * x;
  }
  return up / down;
}

namespace {

using Points = std::vector<Vec2d>;

/// The program's own in their order, and two more.
enum class Pattern { random, grid, jitter, halton, r2, rooks, blue };

/// Sets of samples, a new one for each trial.
class Sampler {
 public:
  explicit Sampler(const StabilityRun& run) : run_(run), random_(run.seed) {
    for (int i = 0; i < run.count(10, 3); ++i) {
      run.check();
      blue_.push_back(BestCandidates(rate_counts.back(), random_).points());
    }
  }
  Points points(Pattern pattern, int count, int trial) {
    Points points;
    if (pattern == Pattern::rooks) return n_rooks(count, random_);
    if (pattern == Pattern::blue) {  // few sets, each moved about
      const Points& set = blue_[static_cast<std::size_t>(trial) % blue_.size()];
      const Vec2d moved(random_.unit(), random_.unit());
      for (int i = 0; i < count; ++i) {
        const Vec2d p = set[static_cast<std::size_t>(i)] + moved;
        points.push_back(p - Vec2d(std::floor(p.x), std::floor(p.y)));
      }
      return points;
    }
    constexpr std::array own{SamplePattern::random, SamplePattern::grid, SamplePattern::jitter, SamplePattern::halton,
                             SamplePattern::r2};
    for (int i = 0; i < count; ++i)
      points.push_back(sample_in_square(own[static_cast<std::size_t>(pattern)], i, count,
                                        {trial, static_cast<int>(run_.seed % 1000)}));
    return points;
  }

 private:
  const StabilityRun& run_;
  Random random_;
  std::vector<Points> blue_;
};

enum Sampled { any_edge, vertical_edge, diagonal_edge, wave, board, subjects };
constexpr std::array subject_names{"any edge", "vertical edge", "edge at 45 degrees", "smooth wave",
                                   "8 x 8 squares anywhere"};

/// RMSE of a pixel for each subject and number of samples.
using Errors = std::array<RateErrors, subjects>;

double edge_error(const Points& points, double direction, Random& random) {
  Edge edge{{std::cos(direction), std::sin(direction)}, 0};
  const Vec2d through(random.unit(), random.unit());
  edge.offset = dot(edge.normal, through);
  double inside = 0;
  for (const Vec2d& p : points) inside += dot(edge.normal, p) < edge.offset ? 1 : 0;
  return inside / static_cast<double>(points.size()) - area_below(edge);
}

/// A wave with one or two periods along each side of the pixel, in any phase. Its mean is 1/2.
double wave_error(const Points& points, Random& random) {
  const double phase = random.between(0, 2 * pi);
  const Vec2d periods(random.coin() ? 1 : 2, (random.coin() ? 1 : 2) * (random.coin() ? 1 : -1));
  double sum = 0;
  for (const Vec2d& p : points) sum += 0.5 * std::sin(2 * pi * dot(p, periods) + phase);
  return sum / static_cast<double>(points.size());
}

/// A board of 8 x 8 squares that lies anywhere, so that some are cut by the pixel's sides. Its mean is 1/2.
double board_error(const Points& points, Random& random) {
  const Vec2d moved(8 * random.unit(), 8 * random.unit());
  double sum = 0;
  for (const Vec2d& p : points) sum += (static_cast<int>(p.x * 8 + moved.x) + static_cast<int>(p.y * 8 + moved.y)) % 2;
  return sum / static_cast<double>(points.size()) - 0.5;
}

Errors errors_of(Pattern pattern, Sampler& sampler, const StabilityRun& run) {
  Random random(run.seed);
  const int trials = run.count(1000, 400);
  Errors errors{};
  for (std::size_t k = 0; k < rate_counts.size(); ++k) {
    run.check();
    for (int i = 0; i < trials; ++i) {
      const Points points = sampler.points(pattern, rate_counts[k], i);
      const std::array<double, subjects> off{edge_error(points, random.between(0, 2 * pi), random),
                                             edge_error(points, 0, random), edge_error(points, pi / 4, random),
                                             wave_error(points, random), board_error(points, random)};
      for (std::size_t s = 0; s < subjects; ++s) errors[s][k] += off[s] * off[s] / trials;
    }
    for (RateErrors& of : errors) of[k] = std::sqrt(of[k]);
  }
  return errors;
}

}  // namespace

void add_sampling_rates(Rows& rows, const StabilityRun& run) {
  Sampler sampler(run);
  struct Pair {
    const char* names;
    Pattern naive, robust;
    std::vector<Sampled> of;
  };
  for (const Pair& pair :
       {Pair{"random and jitter", Pattern::random, Pattern::jitter, {vertical_edge, diagonal_edge, wave, board}},
        Pair{"grid and Halton", Pattern::grid, Pattern::halton, {diagonal_edge, wave, board}},
        Pair{"random and R2", Pattern::random, Pattern::r2, {any_edge, diagonal_edge, wave, board}},
        Pair{"N-rooks and blue noise",
             Pattern::rooks,
             Pattern::blue,
             {any_edge, vertical_edge, diagonal_edge, wave, board}}}) {
    const Errors naive = errors_of(pair.naive, sampler, run), robust = errors_of(pair.robust, sampler, run);
    for (const Sampled subject : pair.of) {
      const std::string name = fmt::format("{}, {}", subject_names[subject], pair.names);
      const RateErrors &a = naive[subject], &b = robust[subject];
      for (std::size_t k = 0; k < rate_counts.size(); ++k)
        rows.add(rate_counts[k], name, a[k], b[k], "RMSE of the pixel");
      // A grid meets both halves of a wave alike, and those of a board as soon as it is as fine: nothing to fit.
      const double none = std::nan("");
      const bool fits = pair.naive != Pattern::grid || subject == diagonal_edge;
      rows.add(0, name + ", slope", fits ? rate(a) : none, rate(b), "exponent of the number of samples");
    }
  }
}

}  // namespace ps::stability
