// Every row of stability_figures/*.tsv against what the experiments measure with their full effort; seed 1.
#include <gtest/gtest.h>

#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "study/stability/experiment.h"
#include "support/stability_table.h"
#include "support/stability_verdict.h"
#include "support/trials.h"

namespace ps::stability_figures_test {
namespace {
using test::StabilityFigure;

class StabilityFigures : public testing::TestWithParam<std::string> {};

// Not under sanitizers, where stability_test.cpp runs the experiments with little effort. In the folder named by
// PIXELSCOPE_STABILITY_TABLE each experiment leaves its rows of assets/gallery/stability.md.
TEST_P(StabilityFigures, HoldAtFullEffort) {
  if (test::trial_divisor > 1) GTEST_SKIP() << "full effort takes too long under a sanitizer";
  const std::vector<StabilityRow> measured = find_stability_experiment(GetParam()).measure({.seed = 1});
  std::ostringstream page;
  for (const StabilityFigure& figure : test::read_stability_figures()) {
    if (figure.experiment != GetParam()) continue;
    EXPECT_EQ(test::fault_of(figure, measured), "")
        << figure.place << ": " << figure.experiment << ", " << figure.series << " at " << figure.knob << "; seed 1";
    page << page_row_start(figure) << page_value(figure, measured) << page_row_end(figure) << '\n';
  }
  if (const char* folder = std::getenv("PIXELSCOPE_STABILITY_TABLE"))
    std::ofstream(std::filesystem::path(folder) / GetParam()) << page.str();
}

std::vector<std::string> all_keys() {
  std::vector<std::string> keys;
  for (const StabilityExperiment& experiment : stability_experiments()) keys.emplace_back(experiment.key);
  return keys;
}

/// "bvh-holes" as "BvhHoles": names of tests hold letters and digits only.
std::string camel_case(const std::string& key) {
  std::string name;
  bool word_begins = true;
  for (const char c : key) {
    if (c != '-') name += word_begins ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
    word_begins = c == '-';
  }
  return name;
}

INSTANTIATE_TEST_SUITE_P(All, StabilityFigures, testing::ValuesIn(all_keys()),
                         [](const auto& tested) { return camel_case(tested.param); });

}  // namespace
}  // namespace ps::stability_figures_test
