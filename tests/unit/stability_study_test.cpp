// A study of stability experiments: what it keeps on disk, takes up again and says about the time that is left.
#include "study/stability_study.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include "base/atomic_file.h"
#include "base/check.h"
#include "support/golden.h"

namespace ps::stability_study_test {
namespace {

StabilityRequest request_in(const std::string& folder) {
  StabilityRequest request;
  request.keys = {"srgb-averaging", "z-vs-1-z", "normal-under-scale"};
  request.folder = fresh_output_folder(folder);
  return request;
}

/// The rows as the experiment itself gives them.
std::string direct(const std::string& key) { return stability_csv(find_stability_experiment(key).measure({})); }

/// Runs until so many rows have come, then cancels.
void run_for_rows(const StabilityRequest& request, int rows) {
  StudyControl control;
  std::size_t seen = 0;
  std::string now;
  const auto stop = [&](const MeasuredExperiment& experiment, const StudyStatus&) {
    if (experiment.key != now) now = experiment.key, seen = 0;
    rows -= static_cast<int>(experiment.rows.size() - seen);
    seen = experiment.rows.size();
    if (rows <= 0) control.cancel();
  };
  EXPECT_THROW(run_stability(request, control, stop), Cancelled);
}

TEST(StabilityStudy, GivesTheRowsOfItsExperimentsAndKeepsThem) {
  const StabilityRequest request = request_in("stability-study");
  StudyControl control;
  const auto measured = run_stability(request, control);
  const auto kept = read_stability(request);
  ASSERT_EQ(measured.size(), 3u);
  ASSERT_EQ(kept.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(measured[i].key, request.keys[i]);
    EXPECT_TRUE(kept[i].complete);
    EXPECT_EQ(stability_csv(measured[i].rows), direct(request.keys[i]));
    EXPECT_EQ(stability_csv(kept[i].rows), direct(request.keys[i]));
  }
}

TEST(StabilityStudy, WhatWasCutOffIsTakenUpAgain) {
  const StabilityRequest request = request_in("stability-study-cut");
  const auto first = static_cast<int>(find_stability_experiment(request.keys[0]).measure({}).size());
  run_for_rows(request, first + 2);
  auto kept = read_stability(request);
  ASSERT_EQ(kept.size(), 2u) << "the third has not begun";
  EXPECT_TRUE(kept[0].complete);
  EXPECT_FALSE(kept[1].complete);
  EXPECT_EQ(kept[1].rows.size(), 2u) << "rows are on disk when they arrive";

  // A crash may cut a line off.
  std::ofstream(request.folder / "runs.jsonl", std::ios::app) << "{\"experiment\":\"z-v";
  std::vector<std::string> begun;
  StudyControl control;
  run_stability(request, control, [&](const MeasuredExperiment& experiment, const StudyStatus&) {
    if (experiment.rows.empty()) begun.push_back(experiment.key);
  });
  EXPECT_EQ(begun, (std::vector<std::string>{"z-vs-1-z", "normal-under-scale"})) << "the first is not measured again";
  kept = read_stability(request);
  ASSERT_EQ(kept.size(), 3u);
  for (const MeasuredExperiment& experiment : kept) {
    EXPECT_TRUE(experiment.complete);
    EXPECT_EQ(stability_csv(experiment.rows), direct(experiment.key));
  }
}

// Also where the line alone would be good: without one of its rows an experiment is not complete.
TEST(StabilityStudy, ADamagedLineCostsItsExperimentAndNothingElse) {
  const StabilityRequest request = request_in("stability-study-damaged");
  StudyControl control;
  run_stability(request, control);
  const auto path = request.folder / "runs.jsonl";
  const std::string text = read_whole_file(path);
  const std::size_t second = text.find("\n{\"experiment\":\"z-vs-1-z\",\"knob\"");
  ASSERT_NE(second, std::string::npos);
  std::string damaged = text;
  damaged[second + 1] = 'x';
  write_file_atomically(path, damaged);
  const auto kept = read_stability(request);
  ASSERT_EQ(kept.size(), 3u);
  EXPECT_TRUE(kept[0].complete);
  EXPECT_FALSE(kept[1].complete);
  EXPECT_TRUE(kept[2].complete);
  std::vector<std::string> begun;
  run_stability(request, control, [&](const MeasuredExperiment& experiment, const StudyStatus&) {
    if (experiment.rows.empty()) begun.push_back(experiment.key);
  });
  EXPECT_EQ(begun, std::vector<std::string>{"z-vs-1-z"});
  for (const MeasuredExperiment& experiment : read_stability(request))
    EXPECT_EQ(stability_csv(experiment.rows), direct(experiment.key));
  const std::string line = damaged.substr(second + 1, damaged.find('\n', second + 1) - second);
  EXPECT_EQ(read_whole_file(path.string() + ".damaged"), line);
}

TEST(StabilityStudy, ResultsOfAnotherSeedAreSetAside) {
  StabilityRequest request = request_in("stability-study-aside");
  request.keys = {"z-vs-1-z"};
  StudyControl control;
  run_stability(request, control);
  const std::string before = read_whole_file(request.folder / "runs.jsonl");
  request.seed = 2;
  run_stability(request, control);
  EXPECT_EQ(read_whole_file(request.folder / "runs.jsonl.damaged"), before);
}

TEST(StabilityStudy, ResultsOfAnotherSeedDoNotMix) {
  StabilityRequest request = request_in("stability-study-seed");
  StudyControl control;
  run_stability(request, control);
  request.seed = 2;
  EXPECT_TRUE(read_stability(request).empty());
  request.keys = {"z-vs-1-z"};
  run_stability(request, control);
  EXPECT_EQ(read_stability(request).size(), 1u);
  request.seed = 1;
  EXPECT_TRUE(read_stability(request).empty());
  request.keys = {"nothing"};
  EXPECT_THROW(run_stability(request, control), InputError);
}

TEST(StabilityStudy, ReportsTheTimeThatIsLeft) {
  StabilityRequest request = request_in("stability-study-time");
  double now = 0;
  const Clock clock = [&] { return now; };
  std::vector<double> left;  // when an experiment begins
  StudyControl control;
  const auto ten_seconds_each = [&](const MeasuredExperiment& experiment, const StudyStatus& status) {
    if (experiment.rows.empty()) {
      left.push_back(status.seconds_left);
      now += 10;
    }
    EXPECT_EQ(status.total, 3);
  };
  run_stability(request, control, ten_seconds_each, clock);
  ASSERT_EQ(left.size(), 3u);
  EXPECT_LT(left[0], 0) << "nothing is known yet";
  EXPECT_NEAR(left[1], 20, 1e-9);
  EXPECT_NEAR(left[2], 10, 1e-9);
  // Known from the folder the next time.
  left.clear();
  request.kept = StabilityRequest::Kept::measure_again;
  run_stability(request, control, ten_seconds_each, clock);
  ASSERT_EQ(left.size(), 3u);
  EXPECT_NEAR(left[0], 30, 1e-9);
}

}  // namespace
}  // namespace ps::stability_study_test
