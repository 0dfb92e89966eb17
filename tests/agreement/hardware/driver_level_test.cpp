// The experiment about mip levels that a driver chooses, against what the specification of OpenGL 3.3 allows every
// driver (3.8.11): max(m_u, m_v) <= rho <= m_u + m_v.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

#include "agreement/hardware/hardware_pair.h"
#include "study/stability/experiment.h"
#include "study/stability/figures.h"
#include "study/stability/pictures.h"
#include "support/emulated.h"
#include "support/environment.h"
#include "support/run_cli.h"

namespace driver_level_test {
namespace {

using namespace ps;

std::map<double, StabilityRow> rows_of(const std::vector<StabilityRow>& all, const std::string& series) {
  std::map<double, StabilityRow> rows;
  for (const StabilityRow& row : all)
    if (row.series == series) rows[row.knob] = row;
  return rows;
}

TEST(DriverLevel, LiesWithinWhatTheSpecificationAllows) {
  PS_NEEDS_HARDWARE(hardware);
  const StabilityExperiment& experiment = find_stability_experiment("driver-level");
  EXPECT_FALSE(why_not_measured(experiment));
  const std::vector<StabilityRow> rows = experiment.measure({});
  constexpr double step = 1.0 / 16;  // of the biases that are tried
  const auto turned = rows_of(rows, "turned, median");
  ASSERT_EQ(turned.size(), 5u);
  for (const auto& [degrees, row] : turned) {
    // Facing the plane, |du/dx| = |dv/dy| = r cos and |dv/dx| = |du/dy| = r sin, and our level is log2 r.
    const double least = std::log2(std::cos(degrees * std::numbers::pi / 180));
    EXPECT_GE(row.naive, least - 2 * step) << degrees;
    EXPECT_LE(row.naive, least + 1 + 2 * step) << degrees;
  }
  // The same formula in a fragment shader gives the rasterizer's level.
  for (const char* series : {"turned, median", "tilted, median"})
    for (const auto& [knob, row] : rows_of(rows, series)) EXPECT_NEAR(row.robust, 0, step) << series << " " << knob;
  for (const char* series : {"turned, beyond a quarter", "tilted, beyond a quarter"})
    for (const auto& [knob, row] : rows_of(rows, series)) EXPECT_LT(row.robust, 1) << series << " " << knob;
  for (const StabilityRow& row : rows) EXPECT_FALSE(quantity_of(experiment, row.series).title.empty());
  EXPECT_EQ(experiment_figures(experiment, rows).front().quantity, &experiment.series.front());
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
  }
}

TEST(DriverLevel, IsNotMeasuredWithoutADriver) {
  if (test::is_emulated()) GTEST_SKIP() << "the emulator has no libraries of OpenGL";
  PS_NEEDS_HARDWARE(hardware);
  const test::ScratchFolder folder;
  const test::Variable vendors("__EGL_VENDOR_LIBRARY_DIRS", folder.path().string());
  const auto result = test::run_cli({"stability", "driver-level"});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.out.find("not measured: no OpenGL: no driver"), std::string::npos) << result.out;
}

}  // namespace
}  // namespace driver_level_test
