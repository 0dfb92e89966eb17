// The stability experiments with little effort, also under sanitizers: each of them runs, its robust method fails
// nowhere, and its pictures render. What the figures are is held by stability_figures_test.cpp, with full effort.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "base/check.h"
#include "study/stability/experiment.h"
#include "study/stability/pictures.h"
#include "support/stability_table.h"
#include "support/stability_verdict.h"
#include "support/trials.h"

namespace ps::stability_test {
namespace {
using test::FigureKind;
using test::FigureMethod;
using test::FigureRule;
using test::StabilityFigure;

/// Share of the full effort.
constexpr double little = test::trial_divisor > 1 ? 0.004 : 0.02;

std::vector<StabilityRow> measured(std::string_view key) {
  return find_stability_experiment(key).measure({.seed = 1, .effort = little});
}

/// The value at a place of a series; a failure and NaN if there is none.
double value_at(const std::vector<StabilityRow>& rows, std::string_view series, double knob, FigureMethod method) {
  for (const StabilityRow& row : rows)
    if (row.series == series && row.knob == knob) return method == FigureMethod::naive ? row.naive : row.robust;
  ADD_FAILURE() << "no series '" << series << "' at " << knob;
  return std::numeric_limits<double>::quiet_NaN();
}
double naive_at(const std::vector<StabilityRow>& rows, std::string_view series, double knob) {
  return value_at(rows, series, knob, FigureMethod::naive);
}

/// After how many rows an experiment is stopped: never, but under a sanitizer after two for those that take 5 to 30
/// seconds there, since their figures ask for many pixels or points. Their later rows are measured in Release alone.
std::size_t enough_rows(std::string_view key) {
  for (const std::string_view slow :
       {"cracks-in-an-image", "ground-sphere-acne", "shadow-map-acne", "triangle-edge-cracks", "peter-panning",
        "gouraud-highlight", "precision", "reflection-self-hit", "grid-octree-borders"})
    if (test::trial_divisor > 1 && key == slow) return 2;
  return std::numeric_limits<std::size_t>::max();
}

class EachExperiment : public testing::TestWithParam<const StabilityExperiment*> {};

// Robust zeros of the table hold with any number of rays, points or pixels; so do values that exist at all.
TEST_P(EachExperiment, RunsWithLittleEffort) {
  const StabilityExperiment& experiment = *GetParam();
  if (experiment.key == "adaptive-sampling-misses") GTEST_SKIP() << "its picture cannot be smaller";
  std::vector<StabilityRow> arrived;
  Progress progress;
  StabilityRun run{.seed = 1, .progress = &progress, .effort = little};
  run.arrived = [&](const StabilityRow& row) {
    arrived.push_back(row);
    if (arrived.size() >= enough_rows(experiment.key)) progress.request_stop();
  };
  std::vector<StabilityRow> rows;
  try {
    rows = experiment.measure(run);
  } catch (const Cancelled&) {
    if (!progress.stop_requested()) throw;
    rows = arrived;
  }
  if (rows.empty()) GTEST_SKIP() << "not on this processor";
  for (const StabilityRow& row : rows) {
    EXPECT_FALSE(row.series.empty());
    EXPECT_FALSE(row.unit.empty()) << row.series;
    EXPECT_NO_THROW(quantity_of(experiment, row.series)) << "each series is declared";
    EXPECT_FALSE(std::isnan(row.naive) && std::isnan(row.robust)) << row.series << " at " << row.knob;
  }
  EXPECT_EQ(stability_csv(arrived), stability_csv(rows)) << "each row is reported as it is measured";
  for (const StabilityFigure& figure : test::read_stability_figures()) {
    if (figure.experiment != experiment.key || figure.rule != FigureRule::zero) continue;
    if (figure.method != FigureMethod::robust || figure.kind == FigureKind::not_reached) continue;
    for (const StabilityRow& row : rows_about(figure, rows))
      EXPECT_EQ(row.robust, 0) << figure.place << ": " << figure.series << " at " << figure.knob << "; seed 1";
  }
}

TEST_P(EachExperiment, CanBeStopped) {
  Progress progress;
  progress.request_stop();
  StabilityRun run{.seed = 1, .progress = &progress, .effort = little};
  EXPECT_THROW(GetParam()->measure(run), Cancelled);
}

/// Whether one frame of a row of frames, `width` x `rows` pixels, has a white pixel.
bool has_white(const Image<Rgb8>& strip, int first_row, int rows, int frame, int width, int gap) {
  for (int y = first_row; y < first_row + rows; ++y)
    for (int x = frame * (width + gap); x < frame * (width + gap) + width; ++x)
      if (strip.at(x, y) == Rgb8{255, 255, 255}) return true;
  return false;
}

// Its third row marks white what differs between the naive and the robust picture: something must, in one frame at
// least.
TEST_P(EachExperiment, FailsVisiblyInItsFilmStrip) {
  const StabilityExperiment& experiment = *GetParam();
  EXPECT_EQ(experiment.frames.empty(), experiment.picture == nullptr);
  constexpr int height = test::trial_divisor > 1 ? 40 : 100, gap = 2;
  Progress progress;
  const auto strip = film_strip(experiment, {.frame_height = height, .gap = gap}, progress);
  ASSERT_EQ(strip.has_value(), experiment.picture != nullptr);
  if (!strip) return;
  const int frames = static_cast<int>(experiment.frames.size()), width = (strip->width() + gap) / frames - gap;
  ASSERT_EQ(strip->width(), frames * (width + gap) - gap);
  ASSERT_EQ(strip->height(), 3 * (height + gap) - gap);
  bool differ = false;
  for (int frame = 0; frame < frames; ++frame)
    differ = differ || has_white(*strip, 2 * (height + gap), height, frame, width, gap);
  if (test::trial_divisor > 1) return;  // too small to show every fault
  EXPECT_TRUE(differ || experiment.key == "painter-s-cycle");
}

TEST_P(EachExperiment, ExplainsItself) {
  const StabilityExperiment& experiment = *GetParam();
  EXPECT_EQ(&find_stability_experiment(experiment.key), &experiment);
  for (const std::string_view text : {experiment.title, experiment.knob, experiment.naive, experiment.robust,
                                      experiment.explanation, experiment.safe})
    EXPECT_FALSE(text.empty());
  EXPECT_GE(std::count(experiment.explanation.begin(), experiment.explanation.end(), '.'), 2);
}

std::vector<const StabilityExperiment*> all_experiments() {
  std::vector<const StabilityExperiment*> all;
  for (const StabilityExperiment& experiment : stability_experiments()) all.push_back(&experiment);
  return all;
}

INSTANTIATE_TEST_SUITE_P(Stability, EachExperiment, testing::ValuesIn(all_experiments()), [](const auto& tested) {
  std::string name(tested.param->key);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

TEST(Stability, AnUnknownExperimentIsRefused) { EXPECT_THROW(find_stability_experiment("nothing"), InputError); }

TEST(Stability, TablesLeaveAMissingMethodEmpty) {
  EXPECT_EQ(stability_csv(std::vector<StabilityRow>{{0.5, "a", 1, std::nan(""), "px"}}),
            "knob,series,naive,robust,unit\n0.5,a,1,,px\n");
}

// A sample on an edge that two triangles share belongs to both under >= 0 and to neither under > 0.
TEST(Stability, WhatOneFillRulePaintsTwiceTheOtherLeavesOut) {
  const auto rows = measured("fill-rule-easy");
  const double twice = naive_at(rows, "vertices on half pixels, >= 0, doubles", 0);
  EXPECT_GT(twice, 0);
  EXPECT_EQ(naive_at(rows, "vertices on half pixels, > 0, holes", 1), twice);
}

// A pair of surfaces is shown in order if a code ends between them. So the gap that 99 % of pairs show, which begin at
// any depth within 5 % of 1,000, follows from where the codes of 24 bits end; with a near plane of 0.001 they are some
// 60 wide there.
TEST(Stability, TheSmallestGapFollowsFromWhereCodesEnd) {
  constexpr double near = 0.001, far = 10000, low = 950, high = 1050, codes = 0x1p24 - 1;
  const auto share = [&](double z) { return (1 - near / z) / (1 - near / far); };
  const auto end_of = [&](double code) { return near / (1 - (code + 0.5) / codes * (1 - near / far)); };
  const double gap = naive_at(measured("near-plane"), "z = 1000", near);
  double hidden = 0;  // length of the depths with no end of a code within the gap behind them
  for (double code = std::floor(codes * share(low)) - 1; end_of(code) < high; ++code)
    hidden += std::max(0.0, std::min(high, end_of(code + 1) - gap) - std::max(low, end_of(code)));
  EXPECT_NEAR(hidden / (high - low), 0.01, 0.005);  // 4,000 pairs: three standard deviations
}

// From z = 9000 on there is one code of 16 bits only, so no gap at all is resolved.
TEST(Stability, NoGapIsResolvedWhereThereIsOneCode) {
  EXPECT_TRUE(std::isnan(naive_at(measured("depth-bits-z-fighting"), "unorm 16, resolved", 9000)));
}

// A tree with the robust slab test visits hardly more nodes.
TEST(Stability, ARobustSlabTestCostsFewNodes) {
  const auto rows = measured("bvh-holes");
  for (const double distance : {0.0, 1e3, 1e5})
    EXPECT_LT(value_at(rows, "cost", distance, FigureMethod::robust), 1.05 * naive_at(rows, "cost", distance));
}

}  // namespace
}  // namespace ps::stability_test
