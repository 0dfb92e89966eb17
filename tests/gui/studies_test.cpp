// The tabs of long studies against the command line: the same errors, the same advice, the same curves.
#include <gtest/gtest.h>

#include <algorithm>
#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>
#include <vector>

#include "gui/program.h"
#include "study/renderer_sweep.h"
#include "study/stability/experiment.h"
#include "support/golden.h"
#include "support/read_csv.h"
#include "support/run_cli.h"

namespace studies_test {
namespace {

using ps::test::play;
using ps::test::read_file;

/// Runs pixelscope-cli with arguments that stand in one line, with blanks between them and none inside.
ps::test::ProgramResult run_line(const std::string& line) {
  std::istringstream words(line);
  return ps::test::run_cli({std::istream_iterator<std::string>(words), {}});
}

/// It must end well; answers what it wrote.
std::string output_of(const std::string& line) {
  const auto result = run_line(line);
  EXPECT_EQ(result.status, 0) << line << "\n" << result.out << result.err;
  return result.out;
}

void write_file(const std::filesystem::path& path, const std::string& text) { std::ofstream(path) << text; }

/// The column "error" of a chart's points.csv.
std::vector<std::string> errors_of(const std::filesystem::path& csv) {
  const auto rows = ps::test::read_csv(read_file(csv));
  const std::vector<std::string>& names = rows.at(0);
  const auto column = std::find(names.begin(), names.end(), "error") - names.begin();
  std::vector<std::string> errors;
  for (std::size_t i = 1; i < rows.size(); ++i) errors.push_back(rows[i].at(static_cast<std::size_t>(column)));
  return errors;
}

std::string expect_errors(const std::vector<std::string>& errors) {
  std::string script;
  for (std::size_t i = 0; i < errors.size(); ++i)
    script += fmt::format("expect chart/of/{}/error ~= {} 1e-12\n", i, errors[i]);
  return script;
}

TEST(Studies, ChartHasTheErrorsOfTheCommandLine) {
  const auto folder = ps::fresh_output_folder("gui-chart-values");
  const std::string view = "cgfs/reflections --size 90x90";
  const auto chart = folder / "chart", merged = folder / "merged";
  output_of(fmt::format("chart {} --sweep reflection-depths --repeats 1 --out {}", view, chart.string()));
  output_of(fmt::format("chart merge {} --metric flip --out {}", chart.string(), merged.string()));
  const auto rmse = errors_of(chart / "points.csv"), flip = errors_of(merged / "points.csv");
  ASSERT_EQ(rmse.size(), 7u);
  ASSERT_EQ(flip.size(), 7u);
  ASSERT_NE(rmse[0], rmse[1]);
  const auto saved = folder / "saved.csv";
  const auto result = play("wait idle\nclick bottom/chart\nchoose chart/sweep reflection-depths\nclick chart/measure\n"
                           "wait idle\nexpect chart/measured 7\n" +
                               expect_errors(rmse) + "choose chart/metric flip\n" + expect_errors(flip) +
                               "click chart/export\nclick chart/csv\nkey Ctrl+A\ntype " + saved.string() +
                               "\nclick file/ok\nwait idle\n"
                               "click chart/export\nclick chart/command\nprint clipboard\nquit\n",
                           folder, "1280x800", view);
  EXPECT_EQ(result.status, 0) << result.errors;
  EXPECT_EQ(result.errors, "");
  EXPECT_EQ(errors_of(saved), flip);
  // What the window copies is the command that measures the same.
  const std::string program = "pixelscope-cli ", end = " --out chart\n";
  ASSERT_TRUE(result.output.starts_with(program) && result.output.ends_with(end)) << result.output;
  std::string command = result.output.substr(program.size(), result.output.size() - program.size() - end.size());
  const auto again = folder / "again";
  output_of(command + " --out " + again.string());
  EXPECT_EQ(errors_of(again / "points.csv"), flip);
}

TEST(Studies, ChartOfARectangleHasTheErrorsOfTheCommandLine) {
  const auto folder = ps::fresh_output_folder("gui-chart-rectangle");
  const std::string view = "cgfs/reflections --size 120x120";
  const auto result = play("wait idle\nkey 1\nwait idle\ndrag view/a/picture 40,30 shift\nwait idle\n"
                           "click bottom/chart\nchoose chart/sweep renderers\nclick chart/change\n"
                           "click chart/setup/part/rectangle\nclick chart/setup/measured-in/linear\nkey Esc\n"
                           "click chart/measure\nwait idle\nexpect chart/status contains rectangle\n"
                           "print region\nprint chart/of/0/error\nprint chart/of/1/error\nquit\n",
                           folder, "1280x800", view);
  ASSERT_EQ(result.status, 0) << result.errors;
  std::istringstream lines(result.output);
  std::string region;
  double ray_tracer = 0, rasterizer = 0;
  lines >> region >> ray_tracer >> rasterizer;
  const auto chart = folder / "chart";
  output_of(fmt::format("chart {} --sweep renderers --linear --region {} --repeats 1 --out {}", view, region,
                        chart.string()));
  const auto errors = errors_of(chart / "points.csv");
  ASSERT_EQ(errors.size(), ps::parse_sweep(ps::renderer_sweep).front().values.size());
  EXPECT_DOUBLE_EQ(ray_tracer, std::stod(errors[0]));
  EXPECT_DOUBLE_EQ(rasterizer, std::stod(errors[1]));
  EXPECT_NE(ray_tracer, rasterizer);
}

class Needs : public testing::TestWithParam<const char*> {};

TEST_P(Needs, AreThoseOfTheCommandLine) {
  const std::string scene = GetParam();
  const auto folder = ps::fresh_output_folder("gui-needs-" + scene.substr(scene.find('/') + 1));
  const std::string view = scene + " --size 90x90";
  const auto needs = nlohmann::json::parse(output_of(fmt::format("needs {} --repeats 1 --json", view)));
  std::string script = "wait idle\nclick bottom/needs\nclick needs/measure\nwait idle\n";
  script += fmt::format("expect needs/error ~= {} 1e-12\n", needs.at("error").get<double>());
  script += fmt::format("expect needs/work {}\n", needs.at("work").get<std::uint64_t>());
  script += fmt::format("expect needs/default-work {}\n", needs.at("default_work").get<std::uint64_t>());
  for (const auto& feature : needs.at("features")) {
    const std::string name = "needs/of/" + feature.at("name").get<std::string>() + "/";
    script += fmt::format("expect {}used {}\n", name, feature.at("used").get<bool>() ? "on" : "off");
    if (!feature.at("used").get<bool>()) continue;
    script += fmt::format("expect {}error-without ~= {} 1e-12\n", name, feature.at("error_without").get<double>());
  }
  const auto result = play(script + "quit\n", folder, "1280x800", view);
  EXPECT_EQ(result.status, 0) << result.errors;
  EXPECT_EQ(result.errors, "");
}

INSTANTIATE_TEST_SUITE_P(Studies, Needs, testing::Values("cgfs/crates", "cgfs/cubes"));

TEST(Studies, StabilityHasTheCurvesOfTheCommandLine) {
  const auto folder = ps::fresh_output_folder("gui-stability-values");
  const std::string name = "srgb-averaging";
  output_of(fmt::format("stability {} --out {}", name, folder.string()));
  const auto table = ps::test::read_csv(read_file(folder / (name + ".csv")));
  std::string script = fmt::format("wait idle\nclick bottom/stability\nclick stability/fill\n"
                                   "click stability/{}\nwait idle\nexpect stability/shown {}\n",
                                   name, name);
  ASSERT_GT(table.size(), 4u);
  for (std::size_t row = 0; row + 1 < table.size(); ++row)  // behind the heading; naive and robust are columns 2 and 3
    script += fmt::format("expect stability/row/{0}/naive ~= {1} 1e-12\nexpect stability/row/{0}/robust ~= {2} 1e-12\n",
                          row, table[row + 1].at(2), table[row + 1].at(3));
  const auto result = play(script + "quit\n", folder, "1280x800");
  EXPECT_EQ(result.status, 0) << result.errors;
  EXPECT_EQ(result.errors, "");
}

TEST(Studies, StabilityIsPausedStoppedAndTakenUpByTheNextStart) {
  const auto folder = ps::fresh_output_folder("gui-stability-kept");
  const std::string state = "env XDG_STATE_HOME=" + std::filesystem::absolute(folder / "state").string();
  const std::string begin = "wait idle\nclick bottom/stability\nclick stability/fill\nwait idle\n";
  const std::string one = "click stability/srgb-averaging\nwait until stability/running off\n"
                          "expect stability/shown srgb-averaging\n";
  const auto first = folder / "first.script", second = folder / "second.script";
  write_file(first, begin + one + "click stability/all\nwait until stability/status contains \" of " +
                        std::to_string(ps::stability_experiments().size()) +
                        " \"\n"
                        "click stability/pause\nexpect stability/paused on\nexpect stability/pause \"Go on\"\n"
                        "wait idle\nexpect stability/status contains \"Paused after\"\n"
                        "click stability/pause\nexpect stability/paused off\n"
                        "click stability/cancel\nwait until stability/running off\n"
                        "expect stability/measure Resume\nexpect stability/measured < 66\n"
                        "expect stability/status contains \"Resume goes on\"\n"
                        "print stability/row/3/naive\nquit\n");
  write_file(second, begin + "expect stability/measured > 0\nclick stability/srgb-averaging\n"
                             "expect stability/running off\nexpect stability/shown srgb-averaging\n"
                             "print stability/row/3/naive\nquit\n");
  std::vector<std::string> printed;
  for (const auto& script : {first, second}) {
    const auto result =
        ps::test::run_window("--window-size 1280x800 cgfs/reflections --size 90x90 --script " + script.string(), state);
    EXPECT_EQ(result.status, 0) << result.errors;
    printed.push_back(result.output);
  }
  EXPECT_EQ(printed[0], printed[1]);
}

TEST(Studies, ResultsAreKeptFromOneStartToTheNext) {
  const auto folder = ps::fresh_output_folder("gui-chart-kept");
  const std::string state = "env XDG_STATE_HOME=" + std::filesystem::absolute(folder / "state").string();
  const std::string begin = "wait idle\nclick bottom/chart\nchoose chart/sweep reflection-depths\n";
  const auto first = folder / "first.script", second = folder / "second.script";
  write_file(first,
             begin + "expect chart/measure contains \"Measure (\"\nclick chart/measure\nwait until chart/measured > 0\n"
                     "click chart/cancel\nwait until chart/running off\n"
                     "expect chart/measure Resume\nexpect chart/measured < 7\nquit\n");
  write_file(second, begin + "expect chart/measure Resume\nclick chart/measure\nwait idle\n"
                             "expect chart/measured 7\nexpect chart/of/6/runs 5\nquit\n");
  for (const auto& script : {first, second}) {
    const auto result = ps::test::run_window(
        "--window-size 1280x800 cgfs/reflections --size 500x500 --script " + script.string(), state);
    EXPECT_EQ(result.status, 0) << result.errors;
  }
}

}  // namespace
}  // namespace studies_test
