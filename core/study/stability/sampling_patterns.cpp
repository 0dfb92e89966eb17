#include <algorithm>
#include <array>
#include <numeric>

#include <fmt/format.h>

#include "raytrace/sampling/pattern.h"
#include "study/stability/support.h"

namespace ps::stability::sampling_patterns {
namespace {

/// An edge through the pixel, dark on one side.
struct Edge {
  Vec2d normal;
  double offset;
};

/// The area of the unit square with normal . p < offset: clip the square, then the shoelace formula.
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

/// Numbers of samples between which a rate is taken.
constexpr std::array rate_counts{16, 64, 256, 1024};
using RateErrors = std::array<double, rate_counts.size()>;

/// The power of the number of samples that the errors follow best: the slope of their logarithms.
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

using Points = std::vector<Vec2d>;

/// As many rows and columns as points, one point anywhere in each (Shirley 1991).
Points rooks(int count, Random& random) {
  std::vector<int> column(static_cast<std::size_t>(count));
  std::iota(column.begin(), column.end(), 0);
  for (std::size_t i = column.size(); i > 1; --i) std::swap(column[i - 1], column[random.below(i)]);
  Points points;
  for (const int x : column) {
    const auto y = static_cast<double>(points.size());
    points.push_back(Vec2d(x + random.unit(), y + random.unit()) / static_cast<double>(count));
  }
  return points;
}

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
  const Points& points() const { return points_; }

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

  std::array<Points, side * side> cells_;
  Points points_;
};

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
    if (pattern == Pattern::rooks) return rooks(count, random_);
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

/// Errors of pixels, and their rates, that the edges of supersampling-rate leave out: patterns on edges at 45 degrees,
/// on a smooth wave and on a board, and two patterns that the program does not offer.
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

/// Root mean square error of the mean of `count` samples over many edges. `angle` is that of the edge's normal; without
/// one, edges have all directions.
double edge_error(SamplePattern pattern, int count, std::optional<double> angle, const StabilityRun& run) {
  Random random(run.seed);
  double sum = 0;
  const int trials = run.count(4000, 1500);
  for (int i = 0; i < trials; ++i) {
    const double direction = angle ? *angle : random.between(0, 2 * pi);
    Edge edge{{std::cos(direction), std::sin(direction)}, 0};
    const Vec2d through(random.unit(), random.unit());
    edge.offset = edge.normal.x * through.x + edge.normal.y * through.y;
    double inside = 0;
    for (int k = 0; k < count; ++k) {
      const Vec2d p = sample_in_square(pattern, k, count, {i, static_cast<int>(run.seed % 1000)});
      inside += edge.normal.x * p.x + edge.normal.y * p.y < edge.offset ? 1 : 0;
    }
    const double error = inside / count - area_below(edge);
    sum += error * error;
  }
  return std::sqrt(sum / trials);
}

void measure_rate(const StabilityRun& run, Rows& rows) {
  struct Pair {
    const char* name;
    SamplePattern naive, robust;
    std::optional<double> angle;
  };
  for (const Pair& pair : {Pair{"any edge, random and jitter", SamplePattern::random, SamplePattern::jitter, {}},
                           Pair{"any edge, grid and Halton", SamplePattern::grid, SamplePattern::halton, {}},
                           Pair{"vertical edge, grid and Halton", SamplePattern::grid, SamplePattern::halton, 0.0},
                           Pair{"vertical edge, random and R2", SamplePattern::random, SamplePattern::r2, 0.0}}) {
    RateErrors naive{}, robust{};
    for (std::size_t i = 0; i < 4; ++i) {
      run.check();
      naive[i] = edge_error(pair.naive, rate_counts[i], pair.angle, run);
      robust[i] = edge_error(pair.robust, rate_counts[i], pair.angle, run);
      rows.add(rate_counts[i], pair.name, naive[i], robust[i], "RMSE of the pixel");
    }
    rows.add(0, std::string(pair.name) + ", slope", rate(naive), rate(robust), "exponent of the number of samples");
  }
  add_sampling_rates(rows, run);
}

/// A board of 8 x 8 squares in one pixel, whose mean is 1/2.
double checker_error(SamplePattern pattern, int count, const StabilityRun& run) {
  double sum = 0;
  const int trials = run.count(4000, 1000);
  for (int i = 0; i < trials; ++i) {
    double mean = 0;
    for (int k = 0; k < count; ++k) {
      const Vec2d p = sample_in_square(pattern, k, count, {i, static_cast<int>(run.seed % 1000)});
      mean += (static_cast<int>(p.x * 8) + static_cast<int>(p.y * 8)) % 2;
    }
    const double error = mean / count - 0.5;
    sum += error * error;
  }
  return std::sqrt(sum / trials);
}

void measure_moire(const StabilityRun& run, Rows& rows) {
  for (const int count : {1, 4, 16, 64, 256}) {
    run.check();
    rows.add(count, "8 x 8 squares in a pixel", checker_error(SamplePattern::grid, count, run),
             checker_error(SamplePattern::jitter, count, run), "RMSE of the pixel");
  }
}

StabilityPicture fence() {
  StabilityPicture picture{.scene = "cgfs/fence"};
  picture.robust.samples_per_pixel = 16;
  picture.robust.sample_pattern = SamplePattern::jitter;
  return picture;
}
StabilityPicture picture_rate(double count) {
  StabilityPicture picture = fence();
  picture.robust.samples_per_pixel = picture.naive.samples_per_pixel = static_cast<int>(count);
  picture.naive.sample_pattern = SamplePattern::random;
  return picture;
}
StabilityPicture picture_moire(double count) {
  StabilityPicture picture = picture_rate(count);
  picture.naive.sample_pattern = SamplePattern::grid;
  return picture;
}

constexpr std::array few{1.0, 4.0, 16.0, 64.0};

}  // namespace

extern const StabilityExperiment supersampling_rate{
    .key = "supersampling-rate",
    .place = {Subject::sampling, 10},
    .set_up = SetUp::reproduction,
    .title = "Convergence rate: what another sample is worth",
    .keywords = "AA, antialias, antialiasing, SSAA, convergence, noise, Monte Carlo",
    .knob = "samples per pixel",
    .naive = "random, or a grid",
    .robust = "jittered grid, or a low-discrepancy sequence",
    .explanation =
        "N random samples form clusters and gaps, so their error falls with N^-0.5. Patterns that spread the samples "
        "evenly fill the gaps, and the error at edges falls with about N^-0.75.",
    .safe = "Any number: the pattern changes the size of the error only.",
    .window = {1, everywhere},
    .series = {{.names = "any edge, random and jitter|*random and jitter",
                .title = "error of the pixel (RMSE)",
                .unit = "share of white",
                .naive = "random",
                .robust = "jittered grid"},
               {.names = "*grid and Halton",
                .title = "error of the pixel (RMSE)",
                .unit = "share of white",
                .naive = "grid",
                .robust = "Halton"},
               {.names = "*random and R2",
                .title = "error of the pixel (RMSE)",
                .unit = "share of white",
                .naive = "random",
                .robust = "R2"},
               {.names = "*N-rooks and blue noise",
                .title = "error of the pixel (RMSE)",
                .unit = "share of white",
                .naive = "N-rooks",
                .robust = "blue noise"},
               {.names = "*random and jitter, slope",
                .title = "exponent of the number of samples in the error",
                .unit = "exponent",
                .naive = "random",
                .robust = "jittered grid"},
               {.names = "*grid and Halton, slope",
                .title = "exponent of the number of samples in the error",
                .unit = "exponent",
                .naive = "grid",
                .robust = "Halton"},
               {.names = "*random and R2, slope",
                .title = "exponent of the number of samples in the error",
                .unit = "exponent",
                .naive = "random",
                .robust = "R2"},
               {.names = "*N-rooks and blue noise, slope",
                .title = "exponent of the number of samples in the error",
                .unit = "exponent",
                .naive = "N-rooks",
                .robust = "blue noise"}},
    .add_rows = measure_rate,
    .picture = picture_rate,
    .frames = {few.begin(), few.end()}};

extern const StabilityExperiment grid_moire{
    .key = "grid-moire",
    .place = {Subject::sampling, 20},
    .set_up = SetUp::reproduction,
    .title = "Moire: a grid of samples over a regular pattern",
    .keywords = "moiré, aliasing, AA, antialias, jitter, regular pattern",
    .knob = "samples per pixel",
    .naive = "grid",
    .robust = "jittered grid",
    .explanation = "If the spacing of the samples is a multiple of the pattern's period, all samples see the same "
                   "phase: 16 samples are as bad as one. Jitter turns that error into noise.",
    .safe = "Grids as fine as the pattern: 64 samples here.",
    .window = {64, everywhere},
    .series = {{.names = "*", .title = "error of the pixel (RMSE)", .unit = "share of white"}},
    .add_rows = measure_moire,
    .picture = picture_moire,
    .frames = {few.begin(), few.end()}};

}  // namespace ps::stability::sampling_patterns
