#include "study/worst_tile.h"

#include <gtest/gtest.h>

#include "image/flip.h"

namespace ps::worst_tile_test {
namespace {

TEST(WorstTile, SeesAnObjectThatTheMeanHides) {
  Image<Rgb8> with(256, 256, Rgb8{128, 128, 128}), none = with;
  for (int y = 100; y < 110; ++y)
    for (int x = 40; x < 50; ++x) with.at(x, y) = {255, 255, 255};
  EXPECT_LT(flip(with, none), 0.01);
  EXPECT_GT(worst_tile_flip(with, none), 0.2);
  EXPECT_EQ(worst_tile_flip(with, with), 0);
}

}  // namespace
}  // namespace ps::worst_tile_test
