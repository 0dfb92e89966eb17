#include <cmath>

#include <gtest/gtest.h>

#include "study/axis.h"
#include "study/label_layout.h"
#include "support/seeded_random.h"

namespace ps::chart_layout_test {
namespace {

TEST(Axis, KeepsOrderAndPutsDecadesAtEqualDistances) {
  const PlotAxis axis = fit_axis({0.01, 100, 3}, AxisScale::logarithmic);
  EXPECT_NEAR(axis.place(1) - axis.place(0.1), axis.place(10) - axis.place(1), 1e-12);
  EXPECT_GT(axis.place(0.01), 0);
  EXPECT_LT(axis.place(100), 1);
  EXPECT_FALSE(axis.zero_place);
}

TEST(Axis, ZeroHasAPlaceBelowTheSmallestValue) {
  const PlotAxis axis = fit_axis({0, 1e-3, 5}, AxisScale::logarithmic);
  EXPECT_TRUE(axis.zero_place);
  EXPECT_LT(axis.place(0), axis.place(1e-3));
  EXPECT_EQ(axis.ticks().front().text, "0");
  ASSERT_TRUE(axis.break_place()) << "zero is not on the scale of the others";
  EXPECT_GT(*axis.break_place(), axis.place(0));
  EXPECT_LT(*axis.break_place(), axis.place(1e-3));
  EXPECT_FALSE(fit_axis({1e-3, 5}, AxisScale::logarithmic).break_place());
  EXPECT_FALSE(fit_axis({0, 5}, AxisScale::linear).break_place());
  const PlotAxis only_zero = fit_axis({0, 0}, AxisScale::logarithmic);
  EXPECT_GE(only_zero.place(0), 0);
  EXPECT_TRUE(std::isfinite(fit_axis({}, AxisScale::linear).place(0.5)));
}

TEST(Axis, TicksLieOnTheAxisInOrderAndSomeHaveText) {
  for (const auto& values : {std::vector<double>{0.5, 0.9}, {1, 1e6}, {3, 3}, {1e-9, 1e9}, {0.001, 0.02}})
    for (const AxisScale scale : {AxisScale::linear, AxisScale::logarithmic}) {
      const PlotAxis axis = fit_axis(values, scale);
      const auto ticks = axis.ticks();
      int labelled = 0;
      for (std::size_t i = 0; i < ticks.size(); ++i) {
        labelled += ticks[i].text.empty() ? 0 : 1;
        if (i > 0) {
          EXPECT_GT(axis.place(ticks[i].value), axis.place(ticks[i - 1].value));
        }
      }
      EXPECT_GE(labelled, scale == AxisScale::linear ? 3 : 1);
      EXPECT_LE(labelled, 14);
    }
}

TEST(Axis, ALoneValueHasRoomAndWholeNumbersNoFractionsBetween) {
  for (const double value : {0.0, 1.0, 0.25, 6191.0}) {
    const PlotAxis axis = fit_axis({value, value}, AxisScale::linear);
    EXPECT_GE(axis.high - axis.low, value == 0 ? 1 : value / 2);
    EXPECT_GE(axis.low, 0);
    EXPECT_LT(axis.place(value), 0.9);
  }
  for (const Tick& tick : fit_axis({0, 1}, AxisScale::linear).ticks()) EXPECT_EQ(tick.value, std::round(tick.value));
  EXPECT_GT(fit_axis({0, 0.5}, AxisScale::linear).ticks().size(), 2u);
  const PlotAxis close = fit_axis({0.97, std::nextafter(0.97, 1)}, AxisScale::linear);
  EXPECT_LT(close.ticks().size(), 15u);
  EXPECT_NEAR(close.place(0.97), 0.5, 1e-6);
}

TEST(Axis, RoundNumbersAreWrittenOut) {
  EXPECT_EQ(tick_text(10000), "10000");
  EXPECT_EQ(tick_text(0.0005), "0.0005");
  EXPECT_EQ(tick_text(3 * 0.1), "0.3");
}

TEST(LabelLayout, LabelsCoverNeitherEachOtherNorMarksNorLeaveTheBox) {
  test::SeededRandom random;
  const Vec2d box{400, 300};
  for (int round = 0; round < 200; ++round) {
    std::vector<LabelWish> wishes(1 + random() % 40);
    for (LabelWish& wish : wishes)
      wish = {{random.between(0, 1) * box.x, random.between(0, 1) * box.y},
              {20 + random.between(0, 1) * 80, 12},
              static_cast<int>(random() % 2)};
    const auto places = place_labels(wishes, box, 4);
    int shown = 0;
    for (std::size_t i = 0; i < wishes.size(); ++i) {
      if (!places[i].shown) continue;
      ++shown;
      const Vec2d low = places[i].corner, high = low + wishes[i].size;
      EXPECT_TRUE(low.x >= 0 && low.y >= 0 && high.x <= box.x && high.y <= box.y);
      for (std::size_t k = 0; k < wishes.size(); ++k) {
        const Vec2d mark = wishes[k].mark;
        EXPECT_FALSE(mark.x > low.x && mark.x < high.x && mark.y > low.y && mark.y < high.y);
        if (k == i || !places[k].shown) continue;
        const Vec2d other = places[k].corner, end = other + wishes[k].size;
        EXPECT_FALSE(low.x < end.x && other.x < high.x && low.y < end.y && other.y < high.y);
      }
    }
    EXPECT_GT(shown, 0) << "there is room for one at least";
  }
}

/// Do two lines cross, and not only touch?
bool cross(const LabelLine& a, const LabelLine& b) {
  const auto side = [](const LabelLine& line, const Vec2d& p) {
    const Vec2d d = line.second - line.first, e = p - line.first;
    return d.x * e.y - d.y * e.x;
  };
  return side(a, b.first) * side(a, b.second) < -1e-9 && side(b, a.first) * side(b, a.second) < -1e-9;
}

TEST(LabelLayout, LinesToLabelsDoNotCross) {
  test::SeededRandom random;
  int lines = 0;
  for (int round = 0; round < 400; ++round) {
    // Marks in a heap, so that most labels stand away from theirs.
    std::vector<LabelWish> wishes(6 + random() % 20);
    for (LabelWish& wish : wishes)
      wish = {
          {200 + random.between(0, 1) * 60, 130 + random.between(0, 1) * 40}, {20 + random.between(0, 1) * 60, 12}, 0};
    const auto places = place_labels(wishes, {400, 300}, 8);
    std::vector<LabelLine> drawn;
    // Drawn from the rim of each mark's own size, which is at most the largest.
    for (std::size_t i = 0; i < wishes.size(); ++i)
      if (const auto line = label_leader(wishes[i], places[i], 4)) drawn.push_back(*line);
    lines += static_cast<int>(drawn.size());
    for (std::size_t i = 0; i < drawn.size(); ++i)
      for (std::size_t k = 0; k < i; ++k) EXPECT_FALSE(cross(drawn[i], drawn[k])) << "round " << round;
  }
  EXPECT_GT(lines, 400);
}

TEST(LabelLayout, LabelsKeepClearOfLinesWhereTheyCan) {
  // The first choice, to the right, is crossed by a line that comes from there; above nothing is.
  const std::vector<LabelWish> wishes{{{100, 100}, {60, 12}, 0}};
  const std::vector<LabelLine> line{{{100, 100}, {300, 104}}};
  const Vec2d free = place_labels(wishes, {400, 300}, 4)[0].corner;
  EXPECT_GT(free.x, 100);
  EXPECT_LT(free.y, 100);
  EXPECT_GT(free.y + 12, 100);
  const LabelPlace place = place_labels(wishes, {400, 300}, 4, line)[0];
  ASSERT_TRUE(place.shown);
  for (double t = 0; t <= 1; t += 1.0 / 1024) {
    const Vec2d p = line[0].first + (line[0].second - line[0].first) * t;
    EXPECT_FALSE(p.x > place.corner.x && p.x < place.corner.x + 60 && p.y > place.corner.y &&
                 p.y < place.corner.y + 12);
  }
  EXPECT_FALSE(label_leader(wishes[0], place, 4)) << "it stands beside its mark";
  EXPECT_TRUE(label_leader(wishes[0], {true, {200, 150}}, 4));
  // Lines everywhere leave no choice: then it is crossed rather than lost.
  std::vector<LabelLine> hatch;
  for (double x = 0; x < 400; x += 5) hatch.push_back({{x, 0}, {x, 300}});
  EXPECT_TRUE(place_labels(wishes, {400, 300}, 4, hatch)[0].shown);
}

TEST(LabelLayout, ALoneLabelIsShown) {
  const auto places = place_labels({{{50, 50}, {60, 12}, 0}}, {400, 300}, 4);
  EXPECT_TRUE(places[0].shown);
}

}  // namespace
}  // namespace ps::chart_layout_test
