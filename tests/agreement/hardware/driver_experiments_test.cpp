// The experiments that only hardware shows: mip levels that blocks of 2 x 2 pixels share, and vertices that the driver
// rounds, against its own word about its sub-pixel bits.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "agreement/hardware/hardware_pair.h"
#include "hardware/gl_thread.h"
#include "study/stability/experiment.h"
#include "study/stability/figures.h"
#include "study/stability/pictures.h"
#include "support/emulated.h"
#include "support/environment.h"
#include "support/run_cli.h"

namespace ps::driver_experiments_test {
namespace {

std::map<double, StabilityRow> rows_of(const std::vector<StabilityRow>& all, const std::string& series) {
  std::map<double, StabilityRow> rows;
  for (const StabilityRow& row : all)
    if (row.series == series) rows[row.knob] = row;
  return rows;
}

TEST(DriverLevel, ChangesBetweenBlocksWhereTheFormulaChangesAnywhere) {
  PS_NEEDS_HARDWARE(hardware);
  const StabilityExperiment& experiment = find_stability_experiment("driver-level");
  EXPECT_FALSE(why_not_measured(experiment));
  const std::vector<StabilityRow> rows = experiment.measure({});
  const auto borders = rows_of(rows, "borders inside blocks"), another = rows_of(rows, "another level");
  ASSERT_EQ(borders.size(), experiment.frames.size());
  ASSERT_EQ(another.size(), experiment.frames.size());
  for (const auto& [tilt, row] : borders) {
    // Half of all rows begin a block. A driver that shares its level among four pixels has no border inside one; some
    // take a difference for each row of a block.
    EXPECT_GT(row.robust, 35) << tilt;
    EXPECT_LT(row.robust, 65) << tilt;
    EXPECT_LT(row.naive, test::drawn_by_llvmpipe() ? 5 : row.robust / 4) << tilt;
  }
  for (const auto& [tilt, row] : another) {
    EXPECT_LT(row.robust, 0.2) << tilt << ": the same formula in a shader";
    EXPECT_GT(row.naive, row.robust) << tilt;
  }
  if (test::drawn_by_llvmpipe()) {
    EXPECT_GT(another.at(80).naive, another.at(35).naive) << "the more, the more the plane is tilted";
  }
  for (const StabilityRow& row : rows) EXPECT_FALSE(quantity_of(experiment, row.series).title.empty());
  EXPECT_EQ(experiment_figures(experiment, rows).front().quantity, &experiment.series.front());
}

TEST(DriverSnapping, MovesTheEdgeByTheSubPixelsThatTheDriverReports) {
  PS_NEEDS_HARDWARE(hardware);
  const std::vector<StabilityRow> rows = find_stability_experiment("driver-snapping").measure({});
  const double steps = std::exp2(hardware::availability().driver->subpixel_bits);
  double largest = 0;
  ASSERT_EQ(rows_of(rows, "edge").size(), 17u);
  for (const auto& [moved, row] : rows_of(rows, "edge")) {
    // Both ends of the edge are rounded, 16 rows from the picture's borders; its middle is off by the mean of both.
    double off = 0;
    for (const double y : {16.0, 4080.0}) {
      const double x = 7 + moved + (y - 64) / 3968;
      off += (std::nearbyint(x * steps) / steps - x) / 2;
    }
    constexpr double counted = 2.0 / 3968;  // a pixel more or less at each end
    EXPECT_NEAR(row.naive, std::abs(off), counted) << moved;
    EXPECT_LE(row.robust, 0.5 / 4096 + counted) << moved;
    largest = std::max(largest, row.naive);
  }
  EXPECT_GT(largest, 0.35 / steps) << "the edge stays in place between two sub-pixels";
}

TEST(DriverLevel, OpensItsPictures) {
  PS_NEEDS_HARDWARE(hardware);
  const StabilityExperiment& experiment = find_stability_experiment("driver-level");
  Progress progress;
  for (const double knob : experiment.frames) {
    const auto opening = open_stability_point(experiment, knob, progress);
    ASSERT_TRUE(opening);
    EXPECT_EQ(opening->naive.renderer, hardware);
    EXPECT_EQ(opening->robust.renderer, hardware);
    EXPECT_EQ(opening->failing.has_value(), opening->failing_percent > 0);
  }
}

TEST(DriverLevel, IsNotMeasuredWithoutADriver) {
  if (test::is_emulated()) GTEST_SKIP() << "the emulator has no libraries of OpenGL";
  PS_NEEDS_HARDWARE(hardware);
  const test::ScratchFolder folder;
  const test::WithoutEglDriver without(folder.path().string());
  const auto result = test::run_cli_well({"stability", "driver-level"});
  EXPECT_NE(result.out.find("not measured: no OpenGL: no driver"), std::string::npos) << result.out;
}

}  // namespace
}  // namespace ps::driver_experiments_test
