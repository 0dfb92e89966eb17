// Zooming and panning: which pixel is under the mouse, and that it stays there.
#include "gui/panels/pictures/picture_transform.h"

#include <gtest/gtest.h>

#include <cfloat>
#include <cmath>
#include <random>

namespace ps::gui::picture_transform_test {
namespace {

const Area area{{100, 50}, {740, 530}};  // 640 x 480
const Vec2i picture_size{600, 400};

TEST(PictureTransform, FitShowsAllOfIt) {
  for (const Vec2i size : {Vec2i(600, 400), Vec2i(20, 3000), Vec2i(10, 10), Vec2i(16384, 16384)}) {
    const Area whole = fitted(size, area).picture_area(size, area);
    EXPECT_GE(whole.min.x, area.min.x - 1);
    EXPECT_GE(whole.min.y, area.min.y - 1);
    EXPECT_LE(whole.max.x, area.max.x + 1);
    EXPECT_LE(whole.max.y, area.max.y + 1);
  }
}

TEST(PictureTransform, FitPrefersWholeFactorsThatCostLittle) {
  EXPECT_EQ(fitted({600, 400}, area).zoom, 1) << "1.067 would fit";
  EXPECT_EQ(fitted({100, 100}, area).zoom, 4) << "4.8 would fit";
  EXPECT_NEAR(fitted({400, 300}, area).zoom, 1.6, 1e-12) << "1 would waste too much";
}

TEST(PictureTransform, ThereAndBackIsTheSamePixel) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> zoom(std::log(0.1), std::log(200.0)), place(0, 1);
  for (int i = 0; i < 500; ++i) {
    const PictureTransform transform{std::exp(zoom(random)), {place(random) * 600, place(random) * 400}};
    const Vec2i pixel(static_cast<int>(place(random) * 600), static_cast<int>(place(random) * 400));
    if (transform.zoom < 2) continue;  // several pixels share a window pixel below
    EXPECT_EQ(transform.pixel_at(transform.to_window({pixel.x + 0.5, pixel.y + 0.5}, area), area), pixel);
  }
}

// Dear ImGui's word for a pointer that is not in the window.
TEST(PictureTransform, APointerOutsideTheWindowIsOnNoPixel) {
  for (const double zoom : {smallest_zoom, 1.0, largest_zoom}) {
    const PictureTransform transform{zoom, {300, 200}};
    EXPECT_EQ(transform.pixel_at({-FLT_MAX, -FLT_MAX}, area), Vec2i(-1000000000, -1000000000));
    EXPECT_EQ(transform.pixel_at({FLT_MAX, FLT_MAX}, area), Vec2i(1000000000, 1000000000));
  }
}

TEST(PictureTransform, ZoomKeepsWhatIsUnderTheMouse) {
  PictureTransform transform = fitted(picture_size, area);
  const ImVec2 mouse{333, 222};
  const Vec2d before = transform.to_picture(mouse, area);
  for (int i = 0; i < 20; ++i) transform = zoomed_about(transform, 1.25, mouse, area);
  const Vec2d after = transform.to_picture(mouse, area);
  EXPECT_GT(transform.zoom, 50);
  EXPECT_NEAR(after.x, before.x, 0.6) << "the corner is on a whole window pixel, half a pixel off at each step";
  EXPECT_NEAR(after.y, before.y, 0.6);
}

TEST(PictureTransform, PanningMovesByWindowPixelsAndKeepsThePictureInSight) {
  const PictureTransform transform{4, {300, 200}};
  EXPECT_EQ(panned(transform, {40, -20}, picture_size).centre, Vec2d(290, 205));
  EXPECT_EQ(panned(transform, {1e6f, 1e6f}, picture_size).centre, Vec2d(0, 0));
  EXPECT_EQ(panned(transform, {-1e6f, -1e6f}, picture_size).centre, Vec2d(600, 400));
}

}  // namespace
}  // namespace ps::gui::picture_transform_test
