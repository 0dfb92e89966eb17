// Ties, the staircase and the band of a chart's front.
#include "study/chart_front.h"
#include "support/seeded_random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace ps::chart_front_test {
namespace {

Chart chart_of(const std::vector<Quartiles>& times, const std::vector<double>& errors, double noise) {
  Chart chart;
  chart.reference_halves.emplace();
  chart.reference_halves->rmse = 2 * noise;
  for (std::size_t i = 0; i < times.size(); ++i) {
    ChartPoint& point = chart.points.emplace_back();
    point.number = static_cast<int>(i);
    const double low = 2 * times[i].q1 - times[i].median, high = 2 * times[i].q3 - times[i].median;
    point.samples_ms = {low, times[i].median, high};
    point.comparison.rmse = errors[i];
    point.compared = true;
  }
  summarise(chart, ErrorMetric::rmse);
  return chart;
}

TEST(ChartFront, AnErrorThatIsBetterByLessThanTheUncertaintyIsATie) {
  const Chart chart = chart_of({{9, 10, 11}, {19, 20, 21}, {40, 41, 42}}, {5, 3, 2.9}, 0.56);
  EXPECT_EQ(front_place(chart, chart.points[0]), FrontPlace::front);
  EXPECT_EQ(front_place(chart, chart.points[1]), FrontPlace::front);
  EXPECT_EQ(front_place(chart, chart.points[2]), FrontPlace::tie) << "cheaper by far is as exact within the noise";
  EXPECT_TRUE(chart.points[2].tie);
  EXPECT_FALSE(chart.points[1].tie);
}

TEST(ChartFront, TimesThatOverlapAreATie) {
  const Chart chart = chart_of({{9, 10, 12}, {11, 11.5, 13}, {30, 31, 32}}, {1, 1, 4}, 0.1);
  EXPECT_EQ(front_place(chart, chart.points[0]), FrontPlace::tie);
  EXPECT_EQ(front_place(chart, chart.points[1]), FrontPlace::tie);
  EXPECT_EQ(front_place(chart, chart.points[2]), FrontPlace::beaten);
}

TEST(ChartFront, UncertaintyIsReadAsEachMetricMeansIt) {
  const ErrorRange rmse = error_range(ErrorMetric::rmse, 0.3, 0.5);
  EXPECT_EQ(rmse.best, 0);
  EXPECT_EQ(rmse.worst, 0.8);
  // 40 dB is an RMSE of 1/100, and noise of 46.02 dB half of that.
  const ErrorRange psnr = error_range(ErrorMetric::psnr, 40, 40 + 20 * std::log10(2.0));
  EXPECT_NEAR(psnr.best, 40 + 20 * std::log10(2.0), 1e-9);
  EXPECT_NEAR(psnr.worst, 40 - 20 * std::log10(1.5), 1e-9);
  const ErrorRange ssim = error_range(ErrorMetric::ssim, 0.9, 0.98);
  EXPECT_NEAR(ssim.best, 0.92, 1e-12);
  EXPECT_NEAR(ssim.worst, 0.88, 1e-12);
  EXPECT_EQ(error_range(ErrorMetric::flip, 0.2, {}).worst, 0.2);
}

TEST(ChartFront, TheStaircaseGoesBySettingsThatExist) {
  const Chart chart = chart_of({{1, 1, 1}, {2, 2, 2}, {4, 4, 4}}, {8, 9, 3}, 0);
  const std::vector<Vec2d> steps = front_staircase(chart);
  ASSERT_EQ(steps.size(), 3u);
  EXPECT_EQ(steps[0], Vec2d(1, 8));
  EXPECT_EQ(steps[1], Vec2d(4, 8)) << "up to the next setting nothing is better";
  EXPECT_EQ(steps[2], Vec2d(4, 3));
}

/// The best error for a cost, of points as they would be measured again.
double best_at(double cost, const std::vector<Vec2d>& points) {
  double best = INFINITY;
  for (const Vec2d& point : points)
    if (point.x <= cost) best = std::min(best, point.y);
  return best;
}

TEST(ChartFront, TheBandHoldsEveryFrontThatTheNoiseAllows) {
  test::SeededRandom random;
  std::uniform_real_distribution<double> unit(0, 1);
  for (int round = 0; round < 300; ++round) {
    std::vector<Quartiles> times(1 + random() % 6);
    std::vector<double> errors;
    for (Quartiles& time : times) {
      const double middle = 2 + 10 * unit(random);
      time = {middle - unit(random), middle, middle + unit(random)};
      errors.push_back(1 + 5 * unit(random));
    }
    const double noise = 0.05 + unit(random);
    const Chart chart = chart_of(times, errors, noise);
    std::vector<Vec2d> again;
    for (const ChartPoint& point : chart.points) {
      const double share = unit(random), off = noise * (2 * unit(random) - 1);
      again.emplace_back(point.cost.q1 + share * (point.cost.q3 - point.cost.q1), std::max(0.0, point.error + off));
    }
    for (const FrontBandPart& part : front_band(chart)) {
      const double cost = std::isinf(part.cost_to) ? part.cost_from + 1 : (part.cost_from + part.cost_to) / 2;
      const double best = best_at(cost, again);
      EXPECT_GE(best, part.error.best - 1e-9);
      EXPECT_LE(best, part.error.worst + 1e-9);
    }
  }
}

}  // namespace
}  // namespace ps::chart_front_test
