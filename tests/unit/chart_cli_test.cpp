#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "base/atomic_file.h"
#include "support/run_cli.h"

namespace chart_cli_test {
namespace {

using ps::test::run_cli;
using ps::test::run_cli_well;
using ps::test::ScratchFolder;

std::vector<std::string> chart_of(const std::string& out, const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments{
      "chart",   "cgfs/reflections", "--size",    "32x24", "--sweep", "reflection-depth=0,3",
      "--sweep", "precision",        "--repeats", "2",     "--out",   out};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

TEST(ChartCommand, WritesTheFilesAndItsErrorsAreThoseOfCompare) {
  const ScratchFolder scratch;
  const std::string out = scratch.file("chart");
  run_cli_well(chart_of(out));
  const auto json = nlohmann::json::parse(ps::read_whole_file(out + "/points.json"));
  ASSERT_EQ(json.at("points").size(), 4u);
  const auto compared = run_cli({"compare", out + "/reference.png", out + "/picture-2.png", "--json"});
  EXPECT_EQ(nlohmann::json::parse(compared.out).at("rmse"), json.at("points").at(2).at("error"));
  const std::string csv = ps::read_whole_file(out + "/points.csv");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 5);
}

TEST(ChartCommand, ShardsAreMerged) {
  const ScratchFolder scratch;
  const std::string first = scratch.file("1"), second = scratch.file("2"), out = scratch.file("all");
  ASSERT_EQ(run_cli(chart_of(first, {"--shard", "1/2"})).status, 0);
  ASSERT_EQ(run_cli(chart_of(second, {"--shard", "2/2"})).status, 0);
  run_cli_well({"chart", "merge", first, second, "--out", out});
  EXPECT_EQ(nlohmann::json::parse(ps::read_whole_file(out + "/points.json")).at("points").size(), 4u);
}

// What cannot act for the renderer of the picture is refused with the reason; beside the renderer itself it may act.
TEST(ChartCommand, RefusesAnOptionThatCannotAct) {
  const ScratchFolder scratch;
  const std::vector<std::string> base{"chart", "cgfs/spheres", "--size", "8x6", "--repeats", "1", "--out"};
  const auto refused = [&](const std::string& out, std::vector<std::string> more) {
    more.insert(more.begin(), base.begin(), base.end());
    more.insert(more.begin() + static_cast<std::ptrdiff_t>(base.size()), scratch.file(out));
    const auto result = run_cli(more);
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), result.status == 2 ? 1 : 0) << result.err;
    return result.status == 2 && result.err.find("changes nothing here: ") != std::string::npos;
  };
  EXPECT_TRUE(refused("1", {"--set", "renderer=rasterizer", "--sweep", "samples-per-pixel=1,4"}));
  EXPECT_TRUE(
      refused("2", {"--set", "renderer=rasterizer", "--sweep", "precision", "--sweep", "samples-per-pixel=1,4"}));
  EXPECT_TRUE(refused("3", {"--sweep", "texture-filter"})) << "no texture";
  EXPECT_FALSE(refused("4", {"--sweep", "samples-per-pixel=1,4"}));
  EXPECT_FALSE(refused("5", {"--sweep", "renderer=ray-tracer,rasterizer", "--sweep", "samples-per-pixel=1,4"}));
}

TEST(ChartCommand, SweepsTheModelFromFullToReduced) {
  const ScratchFolder scratch;
  const std::string out = scratch.file("chart");
  const auto result = run_cli({"chart", "lab/depth-complexity", "--size", "64x48", "--sweep", "needs", "--across",
                               "memory", "--repeats", "1", "--out", out});
  ASSERT_EQ(result.status, 0) << result.err;
  const auto json = nlohmann::json::parse(ps::read_whole_file(out + "/points.json"));
  ASSERT_EQ(json.at("across"), "memory");
  const auto& points = json.at("points");
  ASSERT_GE(points.size(), 2u);
  EXPECT_EQ(points.at(0).at("label"), "full");
  EXPECT_LT(points.back().at("memory_mb"), points.at(0).at("memory_mb"));
  EXPECT_LT(points.back().at("work"), points.at(0).at("work"));
  EXPECT_EQ(run_cli({"chart", "cgfs/lines", "--sweep", "needs", "--out", scratch.file("none")}).status, 2)
      << "its model has no part that could go";
}

TEST(ChartCommand, BadUsageEndsWithTwoAndOneLine) {
  const ScratchFolder scratch;
  const std::string out = scratch.file("chart");
  for (const std::vector<std::string>& more : std::vector<std::vector<std::string>>{{"--metric", "mse"},
                                                                                    {"--region", "1,2,3"},
                                                                                    {"--region", "0,0,33,1"},
                                                                                    {"--shard", "3/2"},
                                                                                    {"--sweep", "nothing"},
                                                                                    {"--sweep", "precision=half"},
                                                                                    {"--repeats", "0"},
                                                                                    {"--reference", "none.png"},
                                                                                    {"--reference-samples", "5"}}) {
    const auto result = run_cli(chart_of(out, more));
    EXPECT_EQ(result.status, 2) << more[1];
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
  }
  EXPECT_EQ(run_cli({"chart", "merge", "--out", out}).status, 2);
  EXPECT_EQ(run_cli({"chart", "merge", scratch.file("none"), "--out", out}).status, 2);
  EXPECT_EQ(run_cli({"chart", "cgfs/spheres"}).status, 2);
}

}  // namespace
}  // namespace chart_cli_test
