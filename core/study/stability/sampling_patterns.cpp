#include <array>

#include <fmt/format.h>

#include "raytrace/sampling/pattern.h"
#include "study/stability/sampling_rates.h"

namespace ps::stability {
namespace {

/// Root mean square error of the mean of `count` samples over many edges. `angle` is that of the normal, or any.
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

std::vector<StabilityRow> measure_rate(const StabilityRun& run) {
  struct Pair {
    const char* name;
    SamplePattern naive, robust;
    std::optional<double> angle;
  };
  Rows rows(run);
  for (const Pair& pair : {Pair{"any edge, random and jitter", SamplePattern::random, SamplePattern::jitter, {}},
                           Pair{"any edge, grid and Halton", SamplePattern::grid, SamplePattern::halton, {}},
                           Pair{"vertical edge, grid and Halton", SamplePattern::grid, SamplePattern::halton, 0.0},
                           Pair{"vertical edge, random and R2", SamplePattern::random, SamplePattern::r2, 0.0}}) {
    RateErrors naive{}, robust{};
    for (std::size_t i = 0; i < 4; ++i) {
      run.check();
      naive[i] = edge_error(pair.naive, rate_counts[i], pair.angle, run);
      robust[i] = edge_error(pair.robust, rate_counts[i], pair.angle, run);
      rows.push_back({static_cast<double>(rate_counts[i]), pair.name, naive[i], robust[i], "RMSE of the pixel"});
    }
    rows.push_back(
        {0, std::string(pair.name) + ", slope", rate(naive), rate(robust), "exponent of the number of samples"});
  }
  add_sampling_rates(rows, run);
  return rows;
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

std::vector<StabilityRow> measure_moire(const StabilityRun& run) {
  Rows rows(run);
  for (const int count : {1, 4, 16, 64, 256}) {
    run.check();
    rows.push_back({static_cast<double>(count), "8 x 8 squares in a pixel",
                    checker_error(SamplePattern::grid, count, run), checker_error(SamplePattern::jitter, count, run),
                    "RMSE of the pixel"});
  }
  return rows;
}

std::vector<StabilityRow> measure_disc(const StabilityRun& run) {
  Rows rows(run);
  for (const double diameter : {0.1, 0.3, 0.5, 0.7, 1.0, 1.4}) {
    run.check();
    Random random(run.seed);
    double centre = 0, corners = 0, both = 0, grid = 0;
    const int discs = run.count(200000, 20000);
    for (int i = 0; i < discs; ++i) {
      const Vec2d at(random.unit(), random.unit());
      const double r2 = diameter * diameter / 4;
      // Every pixel of the plane has its samples, so the nearest one may belong to a neighbour.
      const auto hit = [&](double step, double first) {
        const double dx = std::remainder(at.x - first, step), dy = std::remainder(at.y - first, step);
        return dx * dx + dy * dy < r2;
      };
      const bool c = hit(1, 0.5), k = hit(1, 0);
      centre += c ? 0 : 1;
      corners += k ? 0 : 1;
      both += c || k ? 0 : 1;
      grid += hit(0.25, 0.125) ? 0 : 1;
    }
    const double robust = percent(grid, discs);
    rows.push_back({diameter, "centres", percent(centre, discs), robust, "% missed"});
    rows.push_back({diameter, "corners", percent(corners, discs), robust, "% missed"});
    rows.push_back({diameter, "centres and corners", percent(both, discs), robust, "% missed"});
  }
  return rows;
}

/// Percentage of bars at any place that show in none of the traced columns, every so many pixels.
double bars_missed(int traced, int period, int width, const StabilityRun& run) {
  Random random(run.seed);
  double missed = 0;
  const int bars = run.count(200000, 40000);
  for (int i = 0; i < bars; ++i) {
    const int first = static_cast<int>(random.below(static_cast<std::size_t>(period)));
    bool seen = false;
    for (int x = first; x < first + width; ++x) seen = seen || x % traced == 0;
    missed += seen ? 0 : 1;
  }
  return percent(missed, bars);
}

std::vector<StabilityRow> measure_bars(const StabilityRun& run) {
  Rows rows(run);
  for (const int step : {2, 4, 8, 16})
    for (const int width : {1, 2, 4, 8}) {
      if (width >= step) continue;
      run.check();
      rows.push_back({static_cast<double>(step), fmt::format("bars {} px wide", width),
                      bars_missed(step, step, width, run), bars_missed(1, step, width, run), "% missed"});
    }
  return rows;
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
StabilityPicture picture_bars(double step) {
  StabilityPicture picture = fence();
  picture.robust = Settings{};
  picture.naive.subsampling = static_cast<int>(step);
  return picture;
}

constexpr std::array few{1.0, 4.0, 16.0, 64.0};
constexpr std::array steps{2.0, 4.0, 8.0, 16.0};

}  // namespace

const StabilityExperiment supersampling_rate{
    .key = "supersampling-rate",
    .title = "What another sample is worth",
    .knob = "samples of a pixel",
    .naive = "random, or a grid",
    .robust = "jitter, or a low-discrepancy sequence",
    .explanation =
        "Random samples gather in places and leave others empty, so their error falls with the root of their "
        "number. Spread out, each new one fills a gap, and the error at edges falls with the power 0.75.",
    .safe = "A pattern costs quality, not correctness: any number.",
    .window = {1, everywhere},
    .measure = measure_rate,
    .picture = picture_rate,
    .frames = few};

const StabilityExperiment grid_moire{
    .key = "grid-moire",
    .title = "A grid that beats with a pattern",
    .knob = "samples of a pixel",
    .naive = "grid",
    .robust = "jitter",
    .explanation = "A grid whose step is a multiple of a pattern's sees the same phase everywhere: 16 samples are no "
                   "better than one. Jitter turns that error into noise.",
    .safe = "Grids as fine as the pattern, here 64 samples.",
    .window = {64, everywhere},
    .measure = measure_moire,
    .picture = picture_moire,
    .frames = few};

const StabilityExperiment sub_pixel_disc_missed{
    .key = "sub-pixel-disc-missed",
    .title = "Discs between the samples",
    .knob = "diameter (px)",
    .naive = "a sample at the centre, the corners, or both",
    .robust = "4 x 4 samples",
    .explanation = "What falls between samples is not there for them: a disc is missed with probability 1 - pi D^2 / 4 "
                   "by one sample a pixel. No later step can bring it back.",
    .safe = "Things larger than 1.42 pixels.",
    .window = {1.42, everywhere},
    .measure = measure_disc};

const StabilityExperiment subsampling_bars{
    .key = "subsampling-bars",
    .title = "Bars between traced pixels",
    .knob = "every so many pixels traced",
    .naive = "subsampling, more where objects differ",
    .robust = "every pixel",
    .explanation = "A bar of w pixels is missed by 1 - w / k of the grids that trace every k-th pixel. Looking again "
                   "where neighbours differ does not help, since on both sides of it they agree.",
    .safe = "Things at least as wide as the step.",
    .window = {1, 1},
    .measure = measure_bars,
    .picture = picture_bars,
    .frames = steps};

}  // namespace ps::stability
