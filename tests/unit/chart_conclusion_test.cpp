// What a chart concludes: no order that noise could turn round.
#include "study/chart_conclusion.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "study/chart_front.h"
#include "study/chart_style.h"
#include "support/seeded_random.h"

namespace ps::chart_conclusion_test {
namespace {

struct Given {
  std::string name;
  std::vector<double> times_ms;
  double error = 0;
  Standing standing = Standing::compared;
  std::vector<LeftOutBrief> left_out{};
};

/// A chart of RMSE whose reference is uncertain by `noise`.
Chart chart_of(const std::vector<Given>& points, double noise) {
  Chart chart;
  chart.reference_halves.emplace();
  chart.reference_halves->rmse = 2 * noise;
  for (const Given& given : points) {
    ChartPoint point;
    point.number = static_cast<int>(chart.points.size());
    point.what.name = given.name;
    point.samples_ms = given.times_ms;
    point.comparison.rmse = given.error;
    point.compared = true;
    point.standing = given.standing;
    point.left_out = given.left_out;
    point.work = static_cast<std::uint64_t>(given.times_ms.front());
    chart.points.push_back(point);
  }
  summarise(chart, ErrorMetric::rmse);
  return chart;
}

std::string sentence(const std::vector<Given>& points, double noise = 0.1) {
  return chart_conclusion(chart_of(points, noise)).sentence;
}

TEST(ChartConclusion, APlainCaseSaysWhatIsGainedForWhat) {
  EXPECT_EQ(sentence({{"Samples per pixel: 1", {9, 10, 11}, 1.7},
                      {"Samples per pixel: 4", {38, 40, 42}, 1.0},
                      {"Samples per pixel: 16", {150, 160, 170}, 0.5}}),
            "Samples per pixel: from 1 to 16, the RMSE falls from 1.7 to 0.5 levels of 255 for 16 times the time.");
}

TEST(ChartConclusion, WhatCostsMoreWithinTheUncertaintyGainsNothing) {
  EXPECT_EQ(sentence({{"Samples per pixel: 1", {9, 10, 11}, 1.7},
                      {"Samples per pixel: 16", {60, 65, 70}, 0.7},
                      {"Samples per pixel: 64", {250, 260, 270}, 0.65}}),
            "Samples per pixel: from 1 to 16, the RMSE falls from 1.7 to 0.7 levels of 255 for 6.5 times the time; 64 "
            "takes more without a measurable gain.");
}

TEST(ChartConclusion, ATieIsNotOrdered) {
  const std::vector<Given> tie{{"octree", {9, 10, 12}, 0.30}, {"grid", {10, 11, 13}, 0.35}};
  EXPECT_EQ(sentence(tie), "None of the 2 points is better than another; their times are equal within noise, and their "
                           "errors differ by less "
                           "than the uncertainty of the reference (0.1).");
  EXPECT_TRUE(chart_conclusion(chart_of(tie, 0.1)).claims.empty());
}

TEST(ChartConclusion, OnePointIsComparedWithNothing) {
  EXPECT_EQ(sentence({{"octree", {9, 10, 12}, 0.3}}), "Only one point is measured, so there is nothing to compare.");
  EXPECT_EQ(chart_conclusion(Chart{}).sentence, "");
}

TEST(ChartConclusion, MoreTimeForALargerErrorIsNotAGain) {
  EXPECT_EQ(sentence({{"a", {9, 10, 11}, 2}, {"b", {30, 31, 32}, 1}, {"c", {90, 91, 92}, 3}}),
            "From a to b, the RMSE falls from 2 to 1 levels of 255 for 3.1 times the time; c takes more without a "
            "measurable gain.");
  EXPECT_EQ(sentence({{"a", {9, 10, 11}, 1}, {"b", {30, 31, 32}, 2}}),
            "No point is surely faster or more exact than a.");
}

TEST(ChartConclusion, EqualErrorsLeaveTheTimes) {
  EXPECT_EQ(sentence({{"Accelerator: none", {90, 100, 110}, 0}, {"Accelerator: grid", {9, 10, 11}, 0}}),
            "Accelerator: none takes 10 times the time of grid; their errors are equal.");
  EXPECT_EQ(sentence({{"a", {10, 10, 10}, 0}, {"b", {10, 10, 10}, 0}, {"c", {10, 10, 10}, 0}}),
            "None of the 3 points is better than another; their times are equal within noise, and their errors are "
            "equal.");
}

TEST(ChartConclusion, TimesNearerThanATenthHaveNoOrder) {
  EXPECT_EQ(
      sentence({{"Threads: 1", {10.5, 10.6, 10.7}, 0}, {"Threads: 2", {10, 10.1, 10.2}, 0}}),
      "Threads: none of the 2 points is better than another; their times are equal within noise, and their errors "
      "are equal.");
  EXPECT_EQ(sentence({{"a", {10, 11, 15}, 0}, {"b", {12, 14, 16}, 0}}),
            "None of the 2 points is better than another; their times are equal within noise, and their errors are "
            "equal.")
      << "the quartiles touch";
}

TEST(ChartConclusion, CountedWorkHasNoNoiseButNeverOneTimes) {
  Chart chart = chart_of({{"a", {1004, 1, 1}, 0}, {"b", {1000, 1, 1}, 0}}, 0);
  chart.across = ChartAcross::work;
  summarise(chart, ErrorMetric::rmse);
  EXPECT_EQ(chart_conclusion(chart).sentence, "A needs 0.4 % more work than b; their errors are equal.");
}

// Which of equally exact points is named must not hang on their times, which vary.
TEST(ChartConclusion, NamesTheFirstPointThatHasTheWholeGain) {
  const std::string first =
      "Reflection depth: from 0 to 3, the RMSE falls from 22 to 0.47 levels of 255 for 1.5 times ";
  EXPECT_EQ(sentence({{"Reflection depth: 0", {10, 10, 10}, 22},
                      {"Reflection depth: 3", {15, 15, 15}, 0.47},
                      {"Reflection depth: 8", {15, 14, 14}, 0.47}},
                     0)
                .substr(0, first.size()),
            first);
  EXPECT_EQ(sentence({{"Reflection depth: 0", {10, 10, 10}, 22},
                      {"Reflection depth: 3", {15, 15, 15}, 0.47},
                      {"Reflection depth: 8", {20, 20, 20}, 0.4}},
                     0),
            first + "the time.")
      << "the last hundredth of the gain";
}

TEST(ChartConclusion, TheTruthItselfIsNotCalledExact) {
  const Standing truth = Standing::truth, compared = Standing::compared;
  EXPECT_EQ(
      sentence({{"Guard: offset", {20, 20, 20}, 0.002, truth}, {"Guard: epsilon", {10, 10, 10}, 3.2, compared}}, 0),
      "Guard: the RMSE of epsilon is 3.2 levels of 255 against offset, which is the truth itself; offset takes 2 "
      "times the time of epsilon.");
  EXPECT_EQ(
      sentence({{"Guard: offset", {20, 20, 20}, 0.002, truth}, {"Guard: epsilon", {20, 20, 20}, 0.002, compared}}),
      "Guard: epsilon is as exact as offset, which is the truth itself; their times are equal within noise.");
  EXPECT_EQ(
      sentence(
          {{"Depth: 0", {10, 10, 10}, 5}, {"Depth: 3", {20, 20, 20}, 1}, {"Depth: 64", {40, 40, 40}, 0.01, truth}}),
      "Depth: from 0 to 3, the RMSE falls from 5 to 1 levels of 255 for 2 times the time. 64 is the truth itself.");
}

TEST(ChartConclusion, WhatShowsAnotherPictureOnPurposeHasNoOrder) {
  const Standing other = Standing::other_picture;
  const Chart gamma = chart_of({{"Gamma: 1", {10, 10, 10}, 0, other}, {"Gamma: 2.2", {10, 10, 10}, 18, other}}, 0);
  EXPECT_EQ(chart_conclusion(gamma).sentence,
            "Gamma: each value shows another picture on purpose, so none is more exact than another.");
  for (const ChartPoint& point : gamma.points) EXPECT_FALSE(point.on_front || point.tie);
  EXPECT_EQ(chart_axes(gamma).error_sense, " from the picture as set");
  EXPECT_EQ(
      sentence({{"flat", {10, 10, 10}, 5}, {"phong", {20, 20, 20}, 1}, {"wireframe", {5, 5, 5}, 80, other}}),
      "From flat to phong, the RMSE falls from 5 to 1 levels of 255 for 2 times the time. Wireframe shows another "
      "picture on purpose, so the difference is not an error.");
}

TEST(ChartConclusion, PointsThatLeaveSomethingOutAreNamed) {
  const LeftOutBrief no_shadows{BriefVerb::leaves_out, "shadows"};
  const std::vector<LeftOutBrief> shadows{no_shadows}, both{no_shadows, {BriefVerb::leaves_out, "CSG"}};
  EXPECT_TRUE(sentence({{"rays", {20, 20, 20}, 1}, {"rasterizer", {10, 10, 10}, 5, {}, shadows}})
                  .ends_with(" Rasterizer leaves out shadows."));
  EXPECT_TRUE(sentence({{"a", {20, 20, 20}, 1, {}, both}, {"b", {10, 10, 10}, 5, {}, both}})
                  .ends_with(" Of a and b, each leaves out shadows and CSG."));
}

TEST(ChartConclusion, LabelsThatASentenceCannotTakeAreQuoted) {
  EXPECT_EQ(sentence({{"Normals: of the vertices", {20, 20, 20}, 0}, {"Normals: of the triangle", {10, 10, 10}, 0}}),
            "Normals: \"of the vertices\" takes 2 times the time of \"of the triangle\"; their errors are equal.");
}

TEST(ChartConclusion, FewRunsDoNotOrderTimes) {
  EXPECT_EQ(sentence({{"a", {1}, 3}, {"b", {100}, 1}}),
            "B is the most exact (RMSE 1 levels of 255); fewer than 3 runs do not order their times.");
}

TEST(ChartConclusion, AChartThatLacksPointsSaysSo) {
  Chart chart = chart_of({{"a", {9, 10, 11}, 1}, {"b", {30, 31, 32}, 2}}, 0.1);
  chart.points.emplace_back().what.name = "c";
  EXPECT_TRUE(chart_conclusion(chart).sentence.starts_with("So far: no point")) << chart_conclusion(chart).sentence;
}

TEST(ChartConclusion, StatesNoOrderThatNoiseCouldTurnRound) {
  test::SeededRandom random;
  int claims = 0;
  for (int round = 0; round < 3000; ++round) {
    std::vector<Given> points(1 + random() % 7);
    for (std::size_t i = 0; i < points.size(); ++i) {
      points[i] = {"p" + std::to_string(i), {}, static_cast<double>(random() % 12) / 4};
      const double time = 1 + static_cast<double>(random() % 20);
      const std::size_t runs = random() % 9 == 0 ? 1 : 5;
      for (std::size_t run = 0; run < runs; ++run)
        points[i].times_ms.push_back(time + static_cast<double>(random() % 6));
    }
    const double noise = static_cast<double>(random() % 5) / 4;
    const Chart chart = chart_of(points, noise);
    const ChartConclusion made = chart_conclusion(chart);
    ASSERT_FALSE(made.sentence.empty());
    EXPECT_EQ(made.sentence.back(), '.');
    for (const ChartClaim& claim : made.claims) {
      ++claims;
      const ChartPoint& first = chart.points[static_cast<std::size_t>(claim.first)];
      const ChartPoint& second = chart.points[static_cast<std::size_t>(claim.second)];
      switch (claim.kind) {
      case ChartClaim::Kind::cheaper:
        EXPECT_LT(first.time_ms.q3, second.time_ms.q1) << made.sentence;
        EXPECT_GE(second.time_ms.median, 1.1 * first.time_ms.median) << made.sentence;
        EXPECT_GE(std::min(first.samples_ms.size(), second.samples_ms.size()), 3u);
        break;
      case ChartClaim::Kind::more_exact:
        EXPECT_GT(second.error - first.error, noise) << made.sentence;
        break;
      }
    }
  }
  EXPECT_GT(claims, 1000) << "most charts have an order";
}

}  // namespace
}  // namespace ps::chart_conclusion_test
