// Every figure that the catalogue of stability experiments gives, in stability_given/*.tsv: tab-separated experiment,
// series, knob, naive or robust, the given figure, and where chance decides an allowance and its reason. The figures
// were measured with a program of its own for each experiment. A reason that begins with "if available" marks series
// that some processors lack.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <fmt/format.h>

#include "study/stability/experiment.h"
#include "support/trials.h"

namespace ps {
namespace {

struct Given {
  std::string experiment, series, knob_text, method, text, remark;
  double knob = 0, figure = 0, noise = 0;
};

std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream stream(line);
  for (std::string field; std::getline(stream, field, '\t');) fields.push_back(field);
  fields.resize(7);
  return fields;
}

std::vector<Given> read_figures() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(PIXELSCOPE_TEST_DIR "/property/stability_given"))
    files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::vector<Given> all;
  for (const auto& file : files) {
    std::ifstream stream(file);
    for (std::string line; std::getline(stream, line);) {
      const auto f = fields_of(line);
      all.push_back(
          {f[0], f[1], f[2], f[3], f[4], f[6], std::stod(f[2]), std::stod(f[4]), f[5].empty() ? 0 : std::stod(f[5])});
    }
  }
  return all;
}

/// Zeros are zeros; others lie within a factor of 1.5, or of what chance allows besides.
bool holds(double ours, const Given& given) {
  if (given.figure == 0) return std::abs(ours) <= given.noise;
  const double sign = given.figure < 0 ? -1 : 1, size = sign * given.figure, found = sign * ours;
  return found <= size * 1.5 + given.noise && found >= size / 1.5 - given.noise;
}

/// A row of assets/gallery/stability.md. A bar in a name would begin a cell.
void write_row(std::ostream& table, const Given& given, double ours) {
  std::string series;
  for (const char c : given.series) series += c == '|' ? "\\|" : std::string(1, c);
  table << fmt::format("| {} | {} | {} | {} | {:.4g} | {} | {} |\n", given.experiment, series, given.knob_text,
                       given.method, ours, given.text, given.noise > 0 ? "holds, given " + given.remark : "holds");
}

class StabilityFigures : public testing::TestWithParam<std::string> {};

// With the full effort, so not under sanitizers, where stability_*_test.cpp tries fewer rays. In the folder named by
// PIXELSCOPE_STABILITY_TABLE each experiment leaves its rows of the gallery's table.
TEST_P(StabilityFigures, HoldWithin) {
  if (test::trial_divisor > 1) GTEST_SKIP() << "full effort takes too long under a sanitizer";
  const std::vector<StabilityRow> rows = find_stability_experiment(GetParam()).measure({.seed = 1});
  std::ostringstream table;
  for (const Given& given : read_figures()) {
    if (given.experiment != GetParam()) continue;
    SCOPED_TRACE(fmt::format("{}, {} at {}, {}", given.experiment, given.series, given.knob_text, given.method));
    const auto row = std::find_if(rows.begin(), rows.end(), [&](const StabilityRow& candidate) {
      return candidate.series == given.series && std::abs(candidate.knob - given.knob) <= 1e-6 * std::abs(given.knob);
    });
    if (row == rows.end()) {
      EXPECT_TRUE(given.remark.starts_with("if available")) << "no such row";
      continue;
    }
    ASSERT_TRUE(given.method == "naive" || given.method == "robust");
    const double ours = given.method == "naive" ? row->naive : row->robust;
    EXPECT_TRUE(holds(ours, given)) << ours << " for " << given.text << ", seed 1";
    write_row(table, given, ours);
  }
  if (const char* folder = std::getenv("PIXELSCOPE_STABILITY_TABLE"))
    std::ofstream(std::filesystem::path(folder) / GetParam()) << table.str();
}

std::vector<std::string> experiments_with_figures() {
  std::vector<std::string> keys;
  const std::vector<Given> figures = read_figures();
  for (const StabilityExperiment& experiment : stability_experiments())
    if (std::any_of(figures.begin(), figures.end(), [&](const Given& g) { return g.experiment == experiment.key; }))
      keys.emplace_back(experiment.key);
  return keys;
}

INSTANTIATE_TEST_SUITE_P(All, StabilityFigures, testing::ValuesIn(experiments_with_figures()), [](const auto& tested) {
  std::string name = tested.param;
  std::erase(name, '-');
  return name;
});

TEST(GivenFigures, NameExperimentsThatExist) {
  const std::vector<Given> figures = read_figures();
  EXPECT_GT(figures.size(), 500u);
  for (const Given& given : figures) EXPECT_NO_THROW(find_stability_experiment(given.experiment)) << given.experiment;
}

}  // namespace
}  // namespace ps
