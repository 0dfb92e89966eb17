// The table of what stability experiments are held to, tests/property/stability_figures/*.tsv: how it is read and
// judged, what its rows may assert, and that assets/gallery/stability.md says the same.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <tuple>

#include <fmt/format.h>

#include "base/check.h"
#include "support/refusal.h"
#include "support/stability_table.h"
#include "support/stability_verdict.h"

namespace ps::stability_table_test {
namespace {
using test::FigureKind;
using test::FigureRule;
using test::StabilityFigure;

constexpr const char* header = "experiment\tseries\tknob\tmethod\tkind\trule\tfigure\tallowance\tremark\n";

/// The row that a line of the table is read as, without its first two columns.
StabilityFigure row_of(const std::string& line) {
  return test::parse_stability_figures(header + ("e\ts\t" + line) + "\n", "table").at(0);
}

StabilityRow measured(double knob, double naive, double robust = 0) { return {knob, "s", naive, robust, ""}; }

std::string fault(const std::string& line, std::vector<StabilityRow> rows) { return fault_of(row_of(line), rows); }

TEST(StabilityTable, AGivenFigureHoldsWithinItsFactorAndNeverAtZero) {
  const std::string line = "1\tnaive\treproduced\tgiven\t12";
  EXPECT_EQ(fault(line, {measured(1, 8.01)}), "");
  EXPECT_EQ(fault(line, {measured(1, 17.9)}), "");
  EXPECT_NE(fault(line, {measured(1, 7.9)}), "");
  EXPECT_NE(fault(line, {measured(1, 18.1)}), "");
  EXPECT_NE(fault(line, {measured(1, 0)}), "");
  EXPECT_NE(fault(line, {measured(1, std::nan(""))}), "") << "nothing is measured";
  EXPECT_NE(fault(line, {measured(2, 12)}), "") << "another knob";
  EXPECT_EQ(fault("0\tnaive\treproduced\tgiven\t-0.5", {measured(0, -0.7)}), "");
  EXPECT_NE(fault("0\tnaive\treproduced\tgiven\t-0.5", {measured(0, 0.5)}), "");
}

TEST(StabilityTable, FewEventsWidenAFigureByChanceAlone) {
  const std::string two = "1\tnaive\treproduced\tgiven\t0.001\t2 events";
  EXPECT_EQ(fault(two, {measured(1, 0.0005)}), "");
  EXPECT_EQ(fault(two, {measured(1, 0.005)}), "");
  EXPECT_NE(fault(two, {measured(1, 0.006)}), "");
  EXPECT_NE(fault(two, {measured(1, 0)}), "");
  // Chance allows less than the factor for many events, which is then what counts.
  EXPECT_DOUBLE_EQ(row_of("1\tnaive\treproduced\tgiven\t3\t1000 events").accepts.high, 4.5);
}

// No event leaves exp(-mean), one event 1 - exp(-mean); the others were summed by another program.
TEST(StabilityTable, ChanceIsGarwoodsInterval) {
  const std::map<int, std::pair<double, double>> known{{0, {0, 6.60773}},         {1, {0.00135081, 8.90029}},
                                                       {2, {0.0528815, 10.8696}}, {3, {0.211679, 12.6806}},
                                                       {4, {0.465287, 14.3925}},  {6, {1.17495, 17.6249}}};
  for (const auto& [events, range] : known) {
    EXPECT_NEAR(test::poisson_interval(events).low, range.first, 1e-5 * range.first) << events;
    EXPECT_NEAR(test::poisson_interval(events).high, range.second, 1e-5 * range.second) << events;
  }
  const auto many = test::poisson_interval(10000);  // nearly normal: 3 standard deviations are 300
  EXPECT_NEAR(many.low, 9700, 10);
  EXPECT_NEAR(many.high, 10300, 10);
}

TEST(StabilityTable, ZerosAreExact) {
  EXPECT_EQ(fault("1\trobust\tours\tzero\t0", {measured(1, 5, 0)}), "");
  EXPECT_NE(fault("1\trobust\tours\tzero\t0", {measured(1, 5, 1e-300)}), "");
  EXPECT_EQ(fault("1\tnaive\tours\tabove-zero", {measured(1, 1e-300)}), "");
  EXPECT_NE(fault("1\tnaive\tours\tabove-zero", {measured(1, 0)}), "");
}

TEST(StabilityTable, MagnitudesAndFormulas) {
  EXPECT_EQ(fault("1\tnaive\tours\tmagnitude\t2", {measured(1, 19)}), "");
  EXPECT_NE(fault("1\tnaive\tours\tmagnitude\t2", {measured(1, 21)}), "");
  EXPECT_NE(fault("1\tnaive\tours\tmagnitude\t2", {measured(1, -2)}), "");
  EXPECT_EQ(fault("1\tnaive\tours\tclosed-form\t75", {measured(1, 75)}), "");
  EXPECT_NE(fault("1\tnaive\tours\tclosed-form\t75", {measured(1, 75.001)}), "");
  EXPECT_EQ(fault("1\tnaive\tours\tclosed-form\t75\t1 %", {measured(1, 75.7)}), "");
  EXPECT_NE(fault("1\tnaive\tours\tclosed-form\t75\t0.5", {measured(1, 75.7)}), "");
}

TEST(StabilityTable, SeriesRiseFallOrLieAboveTheRobustMethod) {
  const std::vector<StabilityRow> up{measured(4, 7, 3), measured(1, 2, 1), measured(2, 2, 2)};
  EXPECT_EQ(fault("all\tnaive\tours\trising", up), "");
  EXPECT_NE(fault("all\tnaive\tours\tfalling", up), "");
  EXPECT_NE(fault("1..2\tnaive\tours\trising", up), "") << "the first value is the last";
  EXPECT_EQ(fault("all\trobust\tours\trising", up), "");
  EXPECT_NE(fault("all\tnaive\tours\tabove-robust", up), "") << "equal at 2";
  EXPECT_EQ(fault("4\tnaive\tours\tabove-robust", up), "");
}

TEST(StabilityTable, WhatIsNotReachedMustStillBeMissed) {
  const std::string line = "1\tnaive\tnot reached\tgiven\t0\t\tthe scene is not known";
  EXPECT_EQ(fault(line, {measured(1, 0.1)}), "");
  EXPECT_NE(fault(line, {measured(1, 0)}), "");
}

TEST(StabilityTable, ARowThatNothingMeasuresIsAFault) {
  EXPECT_NE(fault_of(row_of("1\tnaive\tours\tmagnitude\t2"), {}), "");
}

TEST(StabilityTable, RefusesRowsThatMeanNothing) {
  for (const char* line :
       {"x\tnaive\tours\tzero\t0", "1\tbest\tours\tzero\t0", "1\tnaive\ttheirs\tzero\t0", "1\tnaive\tours\tlarge\t0",
        "1\tnaive\tours\tzero\t1", "1\tnaive\tours\tzero\t0\t0.1", "1\tnaive\tours\tgiven\t3",
        "1\tnaive\treproduced\tmagnitude\t3", "1\tnaive\treproduced\tgiven\tmany",
        "1\tnaive\treproduced\tgiven\t3\t0.5", "1\tnaive\treproduced\tgiven\t3\t0 events",
        "1\tnaive\treproduced\tclosed-form\t3\t2 events", "1\tnaive\tnot reached\tgiven\t3",
        "1\tnaive\tnot reached\tzero\t0\t\twhy", "1\tnaive\treference\trising", "1\tnaive\tours\trising",
        "all\tnaive\tours\trising\t3", "1\tnaive\tours\tzero\t0\t\t\tmore"})
    EXPECT_THROW(row_of(line), InputError) << line;
  EXPECT_THROW(test::parse_stability_figures("experiment\tseries\n", "table"), InputError);
  EXPECT_TRUE(test::refusal_of([] {
                test::parse_stability_figures(std::string(header) + "# a remark\ne\ts\t1\tnaive\tours\tzero\t7\n",
                                              "rays.tsv");
              }).starts_with("rays.tsv:3:"))
      << "7 passed as zero";
}

TEST(StabilityFigureRows, NoFigureAboveZeroAcceptsZero) {
  int above = 0;
  for (const StabilityFigure& figure : test::read_stability_figures()) {
    const bool single = figure.rule != FigureRule::rising && figure.rule != FigureRule::falling &&
                        figure.rule != FigureRule::above_robust;
    if (!single || figure.figure == "0") continue;
    ++above;
    EXPECT_FALSE(figure.accepts.holds(0)) << figure.place << ": " << figure.experiment << ", " << figure.series;
  }
  EXPECT_GT(above, 500);
}

// A figure of 0 is held to exactly 0, but where a robust method's angle or length is left with the rounding of double.
TEST(StabilityFigureRows, OnlyRoundingOfDoubleMayTakeThePlaceOfZero) {
  for (const StabilityFigure& figure : test::read_stability_figures()) {
    if (figure.figure != "0" || figure.rule == FigureRule::zero || figure.kind == FigureKind::not_reached) continue;
    EXPECT_EQ(figure.rule, FigureRule::closed_form) << figure.place;
    EXPECT_LE(figure.accepts.high, 1e-9) << figure.place;
    EXPECT_NE(figure.remark.find("rounding of double"), std::string::npos) << figure.place;
  }
}

TEST(StabilityFigureRows, EveryExperimentHasRowsAndNoRowStandsTwice) {
  std::set<std::string> named;
  std::set<std::tuple<std::string, std::string, std::string, test::FigureMethod, FigureRule>> seen;
  for (const StabilityFigure& f : test::read_stability_figures()) {
    EXPECT_NO_THROW(find_stability_experiment(f.experiment)) << f.place;
    named.insert(f.experiment);
    EXPECT_TRUE(seen.insert({f.experiment, f.series, f.knob, f.method, f.rule}).second) << f.place;
  }
  for (const StabilityExperiment& experiment : stability_experiments())
    EXPECT_TRUE(named.contains(std::string(experiment.key))) << experiment.key;
}

TEST(StabilityFigureRows, AnExperimentWithFiguresOfAnotherMeasurementIsAReproduction) {
  std::set<std::string> compared;
  for (const StabilityFigure& figure : test::read_stability_figures())
    if (figure.kind == FigureKind::reproduced || figure.kind == FigureKind::not_reached)
      compared.insert(figure.experiment);
  for (const StabilityExperiment& experiment : stability_experiments())
    EXPECT_EQ(experiment.set_up == SetUp::reproduction, compared.contains(std::string(experiment.key)))
        << experiment.key << ": its set_up says otherwise";
}

TEST(StabilityExperiments, ThoseOfTheDriverAreAbsentWithoutARendererThatUsesIt) {
  for (const StabilityExperiment& experiment : stability_experiments()) {
    EXPECT_FALSE(experiment.measures_driver) << experiment.key << ": this program has no added renderer";
    EXPECT_FALSE(why_not_measured(experiment)) << experiment.key;
  }
  EXPECT_EQ(test::refusal_of([&] { find_stability_experiment("driver-level"); }),
            "experiment 'driver-level': measures the graphics driver, and this program was built without a renderer "
            "that uses it");
  StabilityExperiment made;
  made.measures_driver = true;
  EXPECT_EQ(why_not_measured(made),
            "measures the graphics driver, and this program was built without a renderer that uses it");
}

TEST(StabilityExperiments, EachHasAPlaceOfItsOwn) {
  const auto all = stability_experiments();
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_GT(all[i].place.rank, 0) << all[i].key << " names no place";
    if (i > 0) {
      EXPECT_LT(all[i - 1].place, all[i].place) << all[i].key;
    }
  }
}

std::string text_of(const char* file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

/// "1,318 rows: 590 reproduced, 708 ours, 7 not reached, 13 reference".
std::string counts_text(const std::vector<StabilityFigure>& figures) {
  const auto with_comma = [](std::size_t n) {
    return n < 1000 ? fmt::format("{}", n) : fmt::format("{},{:03}", n / 1000, n % 1000);
  };
  std::map<FigureKind, std::size_t> count;
  for (const StabilityFigure& figure : figures) ++count[figure.kind];
  std::string kinds;
  for (const FigureKind kind :
       {FigureKind::reproduced, FigureKind::ours, FigureKind::not_reached, FigureKind::reference})
    kinds += fmt::format("{}{} {}", kinds.empty() ? "" : ", ", with_comma(count[kind]), kind_text(kind));
  return fmt::format("{} rows: {}", with_comma(figures.size()), kinds);
}

TEST(StabilityPage, CountsAreThoseOfTheTable) {
  const std::string counts = counts_text(test::read_stability_figures());
  EXPECT_NE(text_of("assets/gallery/stability.md").find(counts), std::string::npos)
      << "the page should say '" << counts << "': run assets/gallery/make --stability";
}

/// Rows of the page, without its headings.
std::vector<std::string> page_rows() {
  std::istringstream page(text_of("assets/gallery/stability.md"));
  std::vector<std::string> rows;
  for (std::string line; std::getline(page, line);)
    if (line.starts_with("| ") && !line.starts_with("| experiment ")) rows.push_back(line);
  return rows;
}

TEST(StabilityPage, HasEveryRowOfTheTableAndNoOther) {
  const std::vector<StabilityFigure> table = test::read_stability_figures();
  std::vector<StabilityFigure> first, others;
  for (const StabilityExperiment& experiment : stability_experiments())
    for (const StabilityFigure& figure : table)
      if (figure.experiment == experiment.key)
        (figure.kind == FigureKind::not_reached ? first : others).push_back(figure);
  first.insert(first.end(), others.begin(), others.end());
  const std::vector<std::string> rows = page_rows();
  ASSERT_EQ(rows.size(), first.size()) << "run assets/gallery/make --stability";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    ASSERT_TRUE(rows[i].starts_with(page_row_start(first[i])) && rows[i].ends_with(page_row_end(first[i])))
        << "run assets/gallery/make --stability: the page says\n"
        << rows[i] << "\nand the table, " << first[i].place << ",\n"
        << page_row_start(first[i]) << "..." << page_row_end(first[i]);
  }
}

}  // namespace
}  // namespace ps::stability_table_test
