// The scale of a difference stands beside the picture or below it, and never over it.
#include <gtest/gtest.h>

#include <algorithm>

#include "gui/panels/pictures/difference_scale.h"
#include "gui/theme/theme.h"

namespace difference_places_test {
namespace {

using namespace ps::gui;

double fitted_zoom_of(ps::Vec2i size, const Area& area) {
  return std::min(area.width() / static_cast<double>(size.x), area.height() / static_cast<double>(size.y));
}

TEST(DifferencePlaces, ScaleAndPictureShareNoPixel) {
  int with_scale = 0, beside = 0, below = 0;
  for (const double scale : {1.0, 1.5, 2.0}) {
    theme().set_scale(scale);
    for (const ps::Vec2i size : {ps::Vec2i(600, 600), ps::Vec2i(800, 500), ps::Vec2i(300, 900)})
      for (float width = 200; width <= 2000; width += 150)
        for (float height = 150; height <= 1200; height += 150) {
          const Area place{{10, 20}, {10 + width, 20 + height}};
          const DifferencePlaces places = difference_places(place, size);
          const Area& picture = places.picture;
          EXPECT_TRUE(picture.min.x >= place.min.x && picture.max.x <= place.max.x && picture.max.y <= place.max.y);
          if (!places.scale) {
            EXPECT_EQ(picture.max.x, place.max.x);
            EXPECT_EQ(picture.max.y, place.max.y);
            continue;
          }
          ++with_scale;
          const bool right = places.scale->min.x >= picture.max.x, under = places.scale->min.y >= picture.max.y;
          EXPECT_TRUE(right || under) << width << " x " << height;
          (right ? beside : below) += 1;
          EXPECT_GE(fitted_zoom_of(size, picture), 0.6 * fitted_zoom_of(size, place));
          EXPECT_GE(places.scale->width(), px(272));
          EXPECT_GE(places.scale->height(), px(144));
        }
  }
  theme().set_scale(1);
  EXPECT_GT(with_scale, 200);
  EXPECT_GT(beside, 50);
  EXPECT_GT(below, 50);
}

}  // namespace
}  // namespace difference_places_test
