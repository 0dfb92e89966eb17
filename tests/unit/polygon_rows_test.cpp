#include "raster/clear/polygon_rows.h"

#include <array>

#include <gtest/gtest.h>

namespace ps::raster {
namespace polygon_rows_test {
namespace {

TEST(PolygonRows, AreThosePrintedInTheLab) {
  const std::array<Vec2i, 3> corners{Vec2i{10, 5}, {5, 10}, {15, 15}};
  const std::vector<PolygonRow> printed{{5, 10, 10}, {6, 9, 10},  {7, 8, 11},   {8, 7, 11},   {9, 6, 12},  {10, 5, 12},
                                        {11, 7, 13}, {12, 9, 13}, {13, 11, 14}, {14, 13, 14}, {15, 15, 15}};
  EXPECT_EQ(polygon_rows(corners), printed);
}

TEST(PolygonRows, CountAsManyRowsAsTheLabSays) {
  const std::array<Vec2i, 3> corners{Vec2i{10, 20}, {30, 10}, {20, 40}};
  EXPECT_EQ(polygon_rows(corners).size(), 31u);
  EXPECT_TRUE(polygon_rows({}).empty());
}

}  // namespace
}  // namespace polygon_rows_test
}  // namespace ps::raster
