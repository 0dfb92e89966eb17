#include "study/chart_log.h"

#include <fstream>
#include <random>
#include <regex>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/atomic_file.h"
#include "base/check.h"
#include "options/scene_settings.h"
#include "scene/load.h"
#include "study/chart_files.h"
#include "study/chart_log_lines.h"
#include "study/missing_points.h"
#include "support/refusal.h"
#include "support/run_cli.h"

namespace ps::chart_log_test {
namespace {

/// Five points of two runs each, in a folder.
ChartRequest logged_request(const std::filesystem::path& folder) {
  ChartRequest request;
  request.scene = load_scene("cgfs/spheres");
  request.view = {request.scene.camera, 8, 6};
  request.base = settings_for(request.scene);
  const std::vector<SweepAxis> axes{parse_sweep_axis("gamma=0.5,1,1.5,2,2.5")};
  request.points = sweep_points(axes, request.base, request.base, scene_traits(request.scene));
  request.repeats = 2;
  request.shortest_sample = 0;
  request.folder = folder;
  return request;
}

Chart measure_logged(const std::filesystem::path& folder) {
  StudyControl control;
  return run_chart(logged_request(folder), control);
}

std::vector<std::string> log_lines_of(const std::filesystem::path& path) {
  std::istringstream text(read_whole_file(path));
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  return lines;
}

void write_log_lines(const std::filesystem::path& path, const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  write_file_atomically(path, text);
}

/// The lines of a whole log: the head, picture and run of points 0 to 4 (lines 2 to 11), their second runs (12 to 16).
struct WholeLog {
  test::ScratchFolder scratch;
  std::filesystem::path log = scratch.path() / "runs.jsonl";
  std::vector<std::string> lines;
  WholeLog() {
    measure_logged(scratch.path());
    lines = log_lines_of(log);
  }
  /// With line `number`, from 1, replaced.
  void replace(std::size_t number, const std::string& text) {
    lines.at(number - 1) = text;
    write_log_lines(log, lines);
  }
  Chart merged() const { return merge_charts({scratch.path()}, ErrorMetric::rmse); }
};

std::size_t samples_in(const Chart& chart) {
  std::size_t sum = 0;
  for (const ChartPoint& point : chart.points) sum += point.samples_ms.size();
  return sum;
}

bool log_says(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }
/// A chart's drawing with the lines of its texts joined.
std::string drawing_text(const Chart& chart) {
  return std::regex_replace(chart_svg(chart), std::regex("</text>\n<text[^>]*>"), " ");
}

TEST(ChartLog, ADamagedLineIsNamedAndTheRestIsRead) {
  WholeLog whole;
  ASSERT_EQ(whole.lines.size(), 16u);
  whole.replace(3, "x" + whole.lines[2]);
  const Chart chart = whole.merged();
  ASSERT_EQ(chart.points.size(), 5u);
  EXPECT_EQ(samples_in(chart), 9u) << "all runs but the damaged one";
  ASSERT_EQ(chart.damage.size(), 1u);
  EXPECT_TRUE(log_says(chart.damage[0], whole.log.string() + ":3: found 'x{\"sample\"")) << chart.damage[0];
  EXPECT_EQ(missing_text(chart), "") << "one run of the point is left";
  EXPECT_TRUE(log_says(drawing_text(chart), "Damaged in the log: "));
}

TEST(ChartLog, ResumingKeepsDamagedLinesAsideAndMeasuresOnlyWhatIsLost) {
  WholeLog whole;
  const std::vector<std::string> before = whole.lines;
  whole.replace(3, "x" + before[2]);
  whole.replace(8, before[7] + "\n");           // an empty line is nothing
  whole.replace(16, before[15].substr(0, 12));  // cut off
  StudyControl control;
  int first_done = -1;
  const Chart chart = run_chart(logged_request(whole.scratch.path()), control, [&](const Chart&, const StudyStatus& s) {
    if (first_done < 0) first_done = s.done;
  });
  EXPECT_EQ(first_done, 8);
  EXPECT_EQ(chart.damage.size(), 2u);
  for (const ChartPoint& point : chart.points) EXPECT_GE(point.samples_ms.size(), 2u) << point.what.label;
  EXPECT_EQ(log_lines_of(whole.log.string() + ".damaged"),
            (std::vector<std::string>{"x" + before[2], before[15].substr(0, 12)}));
  const std::vector<std::string> after = log_lines_of(whole.log);
  for (std::size_t i = 1; i < before.size(); ++i)
    if (i != 2 && i != 15) {
      EXPECT_NE(std::find(after.begin(), after.end(), before[i]), after.end()) << i + 1;
    }
  const Chart again = whole.merged();
  EXPECT_TRUE(again.damage.empty());
  EXPECT_EQ(missing_text(again), "");
  EXPECT_GE(samples_in(again), 10u);
}

TEST(ChartLog, APointWithoutRunsIsMissingAndHasNoTime) {
  WholeLog whole;
  whole.replace(3, "x");
  whole.replace(12, "x");
  const Chart chart = whole.merged();
  ASSERT_EQ(chart.points.size(), 5u);
  EXPECT_FALSE(chart.points[0].measured());
  EXPECT_FALSE(chart.points[0].on_front) << "it is not the fastest";
  EXPECT_EQ(missing_text(chart), "point 0 (gamma 0.5) is missing: no timed run");
  const auto json = nlohmann::json::parse(chart_json(chart));
  EXPECT_EQ(json.at("points").size(), 4u);
  EXPECT_EQ(json.at("missing").at(0).at("number"), 0);
  EXPECT_TRUE(log_says(drawing_text(chart), "1 of 5 points are missing"));
}

TEST(ChartLog, RunsWithoutTheirPictureAreMissingUntilItIsDrawnAgain) {
  WholeLog whole;
  whole.replace(4, "{\"picture\":1}");
  Chart chart = whole.merged();
  EXPECT_EQ(missing_text(chart), "point 1 is missing: timed, but its picture's line is lost");
  EXPECT_TRUE(log_says(chart.damage.at(0), "runs.jsonl:4: ")) << chart.damage[0];
  const double error = whole.merged().points[2].error;
  measure_logged(whole.scratch.path());
  chart = whole.merged();
  EXPECT_EQ(missing_text(chart), "");
  EXPECT_TRUE(chart.points[1].compared);
  EXPECT_EQ(chart.points[2].error, error);

  std::filesystem::remove(whole.scratch.path() / "picture-3.png");
  chart = whole.merged();
  EXPECT_TRUE(log_says(chart.damage.at(0), "picture-3.png: no such file")) << chart.damage[0];
  EXPECT_EQ(missing_text(chart), "") << "its numbers are there";
  measure_logged(whole.scratch.path());
  EXPECT_TRUE(whole.merged().damage.empty());
}

TEST(ChartLog, ShardsThatAreNotMergedAreMissing) {
  const test::ScratchFolder scratch;
  ChartRequest request = logged_request(scratch.path() / "1");
  request.shard = parse_shard("1/2");
  StudyControl control;
  run_chart(request, control);
  EXPECT_EQ(missing_text(merge_charts({scratch.path() / "1"}, ErrorMetric::rmse)),
            "points 0, 2, 4 of 5 (from 0) missing: in no log");
}

TEST(ChartLog, WhatNoChartWritesIsNamedWithItsLine) {
  WholeLog whole;
  const std::string good = whole.lines[2];
  std::string deep;
  for (int i = 0; i < 100000; ++i) deep += "{\"a\":";
  deep += "1" + std::string(100000, '}');
  for (const std::string& bad :
       {std::string(R"({"sample":0,"time_ms":-5})"), std::string(R"({"sample":0,"time_ms":1e999})"),
        std::string(R"({"sample":0,"time_ms":1e12})"), std::string(R"({"sample":0,"time_ms":null})"),
        std::string(R"({"sample":0,"time_ms":"3"})"), std::string(R"({"sample":5,"time_ms":3})"),
        std::string(R"({"sample":-1,"time_ms":3})"), std::string(R"({"sample":0.5,"time_ms":3})"),
        std::string(R"({"sample":1e300,"time_ms":3})"), std::string(R"({"sample":18446744073709551615,"time_ms":3})"),
        std::string(R"({"sample":0})"), std::string("[]"), std::string("null"), std::string("{}"),
        std::string("{\"sample\":\"\xff\"}"), std::string(1, '\0'), std::string("\xef\xbb\xbf"), deep}) {
    whole.replace(3, bad);
    const Chart chart = whole.merged();
    ASSERT_EQ(chart.damage.size(), 1u) << bad.substr(0, 60);
    EXPECT_TRUE(log_says(chart.damage[0], "runs.jsonl:3: ")) << chart.damage[0];
    EXPECT_EQ(samples_in(chart), 9u);
    if (bad == deep) {
      EXPECT_TRUE(log_says(chart.damage[0], "found 100000 levels of brackets")) << chart.damage[0];
    }
  }
  // The same goes for a chart that is taken up, which writes the lines again.
  const Chart resumed = measure_logged(whole.scratch.path());
  EXPECT_EQ(resumed.damage.size(), 1u);
  EXPECT_EQ(log_lines_of(whole.log.string() + ".damaged"), std::vector<std::string>{deep});
}

/// Older logs have the texts whole.
TEST(ChartLog, KeepsWhatIsLeftOutAndReadsItFromOlderLogs) {
  ChartPoint point;
  point.left_out = {{BriefVerb::leaves_out, "shadows"}, {BriefVerb::own, "rounds places in float"}};
  nlohmann::ordered_json json = chart_picture_json(point);
  EXPECT_EQ(chart_picture_from(json, 1).left_out, point.left_out);
  json["left-out"] = {"leaves out shadows", "rounds places in float"};
  EXPECT_EQ(brief_texts(chart_picture_from(json, 1).left_out), brief_texts(point.left_out));
}

TEST(ChartLog, WithoutItsFirstLineALogIsRefusedAndStays) {
  WholeLog whole;
  whole.replace(1, whole.lines[0].substr(1));
  const std::string before = read_whole_file(whole.log);
  for (const auto& attempt : {std::function<void()>([&] { whole.merged(); }),
                              std::function<void()>([&] { measure_logged(whole.scratch.path()); })}) {
    EXPECT_TRUE(log_says(test::refusal_of(attempt), "runs.jsonl:1: "));
    EXPECT_EQ(read_whole_file(whole.log), before);
  }
}

TEST(ChartLog, OneProgramAtATimeMeasuresIntoAFolder) {
  const test::ScratchFolder scratch;
  measure_logged(scratch.path());
  const std::string before = read_whole_file(scratch.file("runs.jsonl"));
  {
    const auto lock = FileLock::try_lock(scratch.path() / "runs.lock");
    ASSERT_TRUE(lock);
    EXPECT_FALSE(FileLock::try_lock(scratch.path() / "runs.lock"));
    EXPECT_THROW(measure_logged(scratch.path()), InputError);
    EXPECT_EQ(read_whole_file(scratch.file("runs.jsonl")), before);
    const auto second = test::run_cli({"chart", "cgfs/spheres", "--size", "8x6", "--sweep", "gamma=0.5,1", "--repeats",
                                       "1", "--out", scratch.path().string()});
    EXPECT_EQ(second.status, 2);
    EXPECT_TRUE(log_says(second.err, "another program is measuring a chart there")) << second.err;
  }
  measure_logged(scratch.path());
}

/// Bytes changed at random never end the reading with anything but an InputError, and no line is lost in silence.
TEST(ChartLog, RandomDamageIsNamed) {
  constexpr unsigned seed = 41;
  SCOPED_TRACE(seed);
  WholeLog whole;
  const std::vector<std::string> good = whole.lines;
  std::mt19937 random(seed);
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  for (int trial = 0; trial < 100; ++trial) {
    whole.lines = good;
    const std::size_t number = 2 + below(good.size() - 1);
    std::string line = good[number - 1];
    line[below(line.size())] = static_cast<char>(random() % 256);
    if (log_says(line, "\n")) continue;
    whole.replace(number, line);
    try {
      const Chart chart = whole.merged();
      if (chart.damage.empty()) continue;  // another number, or another text
      EXPECT_TRUE(log_says(chart.damage[0], "runs.jsonl:" + std::to_string(number) + ": ") ||
                  log_says(chart.damage[0], "png"))
          << chart.damage[0];
      EXPECT_GE(samples_in(chart), 9u) << line;
    } catch (const InputError& error) {
      EXPECT_TRUE(log_says(error.what(), "another chart")) << error.what();
    }
  }
}

TEST(ChartCommand, AMergeThatLacksSomethingEndsWithOne) {
  WholeLog whole;
  const std::string out = whole.scratch.file("merged");
  EXPECT_EQ(test::run_cli({"chart", "merge", whole.scratch.path().string(), "--out", out}).status, 0);
  whole.replace(3, "x");
  whole.replace(12, "x");
  const auto merged = test::run_cli({"chart", "merge", whole.scratch.path().string(), "--out", out});
  EXPECT_EQ(merged.status, 1);
  EXPECT_TRUE(log_says(merged.err, "runs.jsonl:3: ")) << merged.err;
  EXPECT_TRUE(log_says(merged.err, "point 0 (gamma 0.5) is missing: no timed run")) << merged.err;
  EXPECT_TRUE(log_says(merged.out, "gamma 0.5: not measured")) << merged.out;
  const std::string csv = read_whole_file(out + "/points.csv");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 5) << "the heading and four points";
}

}  // namespace
}  // namespace ps::chart_log_test
