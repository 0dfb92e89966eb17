// What each series of the experiments measures, and how it is drawn.
#include "study/stability/figures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "support/stability_table.h"

namespace ps::experiment_figures_test {
namespace {

const double none = std::nan("");

/// All series of an experiment that the table of figures names.
std::set<std::string> series_of(std::string_view experiment) {
  std::set<std::string> series;
  static const auto table = test::read_stability_figures();
  for (const test::StabilityFigure& row : table)
    if (row.experiment == experiment) series.insert(row.series);
  return series;
}

bool plain(std::string_view text) { return !text.empty() && text.find(" or ") == std::string_view::npos; }

TEST(ExperimentFigures, EverySeriesHasATitleAUnitAndADirection) {
  for (const StabilityExperiment& experiment : stability_experiments()) {
    EXPECT_FALSE(experiment.series.empty()) << experiment.key;
    const auto all = series_of(experiment.key);
    EXPECT_FALSE(all.empty()) << experiment.key;
    for (const std::string& series : all) {
      const StabilitySeries& quantity = quantity_of(experiment, series);
      EXPECT_TRUE(plain(quantity.title)) << experiment.key << ": " << series;
      EXPECT_TRUE(plain(quantity.unit)) << experiment.key << ": " << series;
      EXPECT_TRUE(plain(knob_title(experiment, quantity))) << experiment.key << ": " << series;
      EXPECT_FALSE(better_key(quantity.better).empty());
    }
    for (const StabilitySeries& quantity : experiment.series) EXPECT_TRUE(plain(quantity.title)) << experiment.key;
    EXPECT_NE(experiment.series.front().better, Better::neither)
        << experiment.key << ": the list shows the worst of the first";
  }
}

TEST(ExperimentFigures, WhatIsShownFirstHasNaiveAndRobust) {
  for (const StabilityExperiment& experiment : stability_experiments()) {
    std::vector<StabilityRow> rows;
    for (const std::string& series : series_of(experiment.key)) rows.push_back({1, series, 1, 0, "px"});
    const auto figures = experiment_figures(experiment, rows);
    ASSERT_FALSE(figures.empty());
    EXPECT_EQ(figures.front().quantity, &experiment.series.front()) << experiment.key;
    EXPECT_NE(first_figure_text(experiment, rows).find(experiment.series.front().title), std::string::npos);
  }
}

const StabilityExperiment experiment = [] {
  StabilityExperiment made;
  made.key = "made";
  made.knob = "gap (px)";
  made.naive = "a";
  made.robust = "b";
  made.series = {
      {.names = "second|*", .title = "pixels that are wrong", .unit = "%"},
      {.names = "kept*", .title = "part that is kept", .unit = "of 1", .better = Better::higher},
      {.names = "by bits*", .title = "misses", .unit = "per million", .cases = {{32, "float"}, {64, "double"}}}};
  return made;
}();

TEST(ExperimentFigures, TheMostSpecificPatternTakesASeries) {
  EXPECT_EQ(quantity_of(experiment, "anything").title, "pixels that are wrong");
  EXPECT_EQ(quantity_of(experiment, "kept, mean").title, "part that is kept");
  EXPECT_LT(series_order(experiment, "second"), series_order(experiment, "first"));
}

TEST(ExperimentFigures, CurvesAndBars) {
  const std::vector<StabilityRow> rows{{2, "first", 4, 0, ""},         {1, "first", 3, 0, ""},
                                       {1, "second", 7, 1, ""},        {3, "second", 9, 1, ""},
                                       {32, "by bits, one", 5, 0, ""}, {64, "by bits, one", 1, 0, ""},
                                       {0, "kept a", 0.5, 0.9, ""},    {0, "kept b", 0.1, 0.8, ""}};
  const auto figures = experiment_figures(experiment, rows);
  ASSERT_EQ(figures.size(), 4u);
  EXPECT_EQ(figures[0].name, "second") << "the text speaks of it";
  EXPECT_EQ(figures[0].form, FigureForm::curve);
  EXPECT_EQ(figures[1].name, "first");
  EXPECT_EQ(figures[1].rows.front().knob, 1) << "in the order of the knob";
  EXPECT_EQ(figures[2].name, "part that is kept");
  EXPECT_EQ(figures[2].form, FigureForm::bars);
  EXPECT_EQ(figures[2].rows[1].name, "kept b");
  EXPECT_EQ(figures[2].axis_title(), "part that is kept (of 1), higher is better");
  EXPECT_EQ(figures[3].rows[0].name, "float");
  EXPECT_EQ(figures[3].rows[1].name, "double");
}

TEST(ExperimentFigures, TheWorstFollowsTheDirection) {
  const std::vector<StabilityRow> rows{{1, "kept", 0.99, 0.999, ""},
                                       {2, "kept", 0.03, 0.998, ""},
                                       {3, "kept", none, 1, ""},
                                       {1, "second", 2, 0, ""},
                                       {2, "second", 6, 0, ""}};
  const auto figures = experiment_figures(experiment, rows);
  EXPECT_EQ(worst_row(figures[0])->naive, 6);
  EXPECT_EQ(worst_row(figures[1])->naive, 0.03) << "of what is kept the least is worst";
  EXPECT_EQ(worst_row(figures[1])->robust, 0.998);
}

TEST(ExperimentFigures, RoundingIsNotPrintedAsAResult) {
  EXPECT_EQ(result_text(8.967e-14, 143), "rounding only");
  EXPECT_EQ(result_text(0, 143), "0");
  EXPECT_EQ(result_text(1.3e-7, 2e-7), "1.3e-07") << "it is the size of what stands beside it";
  EXPECT_EQ(result_text(106950, 106950), "106950");
  EXPECT_EQ(result_text(0.03153, 1), "0.0315");
}

TEST(ExperimentFigures, TheTableGetsItsMeaningBehindItsColumns) {
  const std::vector<StabilityRow> rows{{32, "by bits, one", 5, 0, "misses"}};
  EXPECT_EQ(stability_csv_with_meaning(stability_csv(rows), experiment, rows),
            "knob,series,naive,robust,unit,quantity,quantity_unit,better,knob_title,knob_name\n"
            "32,\"by bits, one\",5,0,misses,misses,per million,lower,gap (px),float\n");
}

}  // namespace
}  // namespace ps::experiment_figures_test
