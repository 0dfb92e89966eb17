#include "inspect/watch.h"

#include <gtest/gtest.h>

namespace ps {
namespace {

TEST(Watch, RecordsLineNameAndValue) {
  PS_WATCH("nobody listens", 1);
  WatchCollector collector;
  const int line = __LINE__ + 1;
  PS_WATCH("t", 2.5);
  PS_WATCH("n", 3);
  ASSERT_EQ(collector.watches().size(), 2u);
  EXPECT_EQ(collector.watches()[0], (Watch{line, "t", "2.5"}));
  EXPECT_EQ(collector.watches()[1].value, "3");
}

TEST(Watch, ScopesDropWhatTheyDoNotKeep) {
  WatchCollector collector;
  for (int triangle = 0; triangle < 3; ++triangle) {
    WatchScope scope;
    PS_WATCH("triangle", triangle);
    if (triangle == 1) scope.keep();
  }
  ASSERT_EQ(collector.watches().size(), 1u);
  EXPECT_EQ(collector.watches()[0].value, "1");
}

TEST(Watch, InnermostCollectorReceivesAndTheLimitHolds) {
  WatchCollector outer;
  {
    WatchCollector inner;
    for (int i = 0; i < 10'005; ++i) PS_WATCH("i", i);
    EXPECT_EQ(inner.watches().size(), WatchCollector::limit);
    EXPECT_EQ(inner.dropped(), 5u);
  }
  EXPECT_TRUE(outer.watches().empty());
  PS_WATCH("after", true);
  EXPECT_EQ(outer.watches().size(), 1u);
}

}  // namespace
}  // namespace ps
