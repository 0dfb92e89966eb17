#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "raytrace/sampling/pattern.h"
#include "study/stability/sampling_rates.h"
#include "study/stability/support.h"

namespace ps::stability::sampling_patterns {
namespace {

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
