#include "record/watch.h"

#include <gtest/gtest.h>

namespace ps::watch_test {
namespace {

TEST(Watch, RecordsLineNameAndValue) {
  PS_WATCH("nobody listens", 1);
  WatchCollector collector;
  const int line = __LINE__ + 1;
  PS_WATCH("t", 2.5);
  PS_WATCH("n", 3);
  ASSERT_EQ(collector.watches().size(), 2u);
  EXPECT_EQ(collector.watches()[0], (Watch{line, "t", 2.5}));
  EXPECT_EQ(watch_text(collector.watches()[0].value), "2.5");
  EXPECT_EQ(watch_text(collector.watches()[1].value), "3");
}

TEST(Watch, InstancesNest) {
  WatchCollector collector;
  for (int ray = 0; ray < 2; ++ray) {
    PS_EACH("ray", ray);
    for (const char* sphere : {"red", "green"}) {
      PS_EACH("sphere", sphere);
      PS_WATCH("t", ray);
    }
  }
  ASSERT_EQ(collector.instances().size(), 6u);
  EXPECT_EQ(collector.instances()[0].parent, -1);
  EXPECT_EQ(collector.instances()[2].parent, 0);
  EXPECT_EQ(collector.instances()[5].parent, 3);
  EXPECT_EQ(watch_text(collector.instances()[5].value), "green");
  EXPECT_EQ(collector.watches().at(3).instance, 5);
}

/// Only the triangle and the row that reach pixel (2, 1) stay, with the loop over corners inside the triangle.
TEST(Watch, KeepsWhatReachesThePixel) {
  WatchCollector collector(Vec2i(2, 1));
  for (int triangle = 0; triangle < 3; ++triangle) {
    PS_REACHING("triangle", triangle);
    for (int corner = 0; corner < 3; ++corner) {
      PS_EACH("corner", corner);
      PS_WATCH("place", corner);
    }
    for (int y = triangle; y < triangle + 2; ++y) {
      PS_REACHING("row", y);
      PS_WATCH("left", 0);
      for (int x = 0; x < 4; ++x) {
        PS_PIXEL(x, y);
        PS_EACH("tap", x);
        PS_WATCH("x", x);
      }
    }
  }
  std::vector<std::string> kept;
  for (const Watch& watch : collector.watches()) kept.push_back(std::string(watch.name) + watch_text(watch.value));
  const std::vector<std::string> expected{"place0", "place1", "place2", "left0", "x2",
                                          "place0", "place1", "place2", "left0", "x2"};
  EXPECT_EQ(kept, expected);
  EXPECT_EQ(collector.instances().size(), 14u);  // twice: triangle, three corners, row, pixel, tap
}

TEST(Watch, InnermostCollectorReceivesAndTheLimitHolds) {
  WatchCollector outer;
  {
    WatchCollector inner;
    for (std::size_t i = 0; i < WatchCollector::limit + 5; ++i) {
      PS_EACH("i", i);
      PS_WATCH("i", i);
    }
    EXPECT_EQ(inner.watches().size(), WatchCollector::limit);
    EXPECT_EQ(inner.instances().size(), WatchCollector::limit);
    EXPECT_EQ(inner.dropped(), 5u);
  }
  EXPECT_TRUE(outer.watches().empty());
  PS_WATCH("after", 1);
  EXPECT_EQ(outer.watches().size(), 1u);
}

}  // namespace
}  // namespace ps::watch_test
