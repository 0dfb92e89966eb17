// Where samples lie on the viewport, against positions worked out from the book's and CGPP's formulas.
#include "frame/viewport.h"

#include <gtest/gtest.h>

namespace ps::viewport_test {
namespace {

View view(int width, int height) {
  View result;
  result.width = width;
  result.height = height;
  return result;
}

TEST(Viewport, BookCornerIsXOver600) {
  Settings settings;
  settings.sample_position = SamplePosition::corner;
  const auto viewport = make_viewport<double>(view(600, 600), settings);
  EXPECT_EQ(viewport.at(0, 0).x, -0.5);
  EXPECT_EQ(viewport.at(599, 0).x, 299.0 / 600);
  EXPECT_EQ(viewport.at(0, 0).y, 299.0 / 600);
  EXPECT_EQ(viewport.at(0, 599).y, -0.5);
}

TEST(Viewport, CentreIsSymmetric) {
  const auto viewport = make_viewport<double>(view(600, 600), {});
  EXPECT_EQ(viewport.at(0, 0).x, -299.5 / 600);
  EXPECT_EQ(viewport.at(599, 599).x, 299.5 / 600);
  EXPECT_EQ(viewport.at(599, 599).y, -299.5 / 600);
}

TEST(Viewport, FitKeepsTheSideThatItNames) {
  Settings settings;
  EXPECT_EQ(make_viewport<double>(view(1200, 600), settings).width, 2);
  settings.viewport_fit = ViewportFit::width;
  EXPECT_EQ(make_viewport<double>(view(1200, 600), settings).height, 0.5);
  settings.viewport_fit = ViewportFit::stretch;
  const auto stretched = make_viewport<double>(view(1200, 600), settings);
  EXPECT_EQ(stretched.width, 1);
  EXPECT_EQ(stretched.height, 1);
}

TEST(Viewport, SpanOfCentresPutsTheOutermostSamplesOnTheBorder) {
  Settings settings;
  settings.field_of_view_span = FieldOfViewSpan::centres;
  const auto viewport = make_viewport<double>(view(101, 101), settings);
  EXPECT_EQ(viewport.at(0, 50).x, -0.5);
  EXPECT_EQ(viewport.at(100, 50).x, 0.5);
  EXPECT_EQ(make_viewport<double>(view(1, 1), settings).at(0, 0).x, 0);
}

}  // namespace
}  // namespace ps::viewport_test
