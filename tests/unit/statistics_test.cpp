#include "base/statistics.h"

#include <gtest/gtest.h>

namespace ps::statistics_test {
namespace {

TEST(Statistics, QuartilesInterpolateBetweenNeighbours) {
  const Quartiles odd = quartiles({5, 1, 4, 2, 3});
  EXPECT_DOUBLE_EQ(odd.q1, 2);
  EXPECT_DOUBLE_EQ(odd.median, 3);
  EXPECT_DOUBLE_EQ(odd.q3, 4);
  const Quartiles even = quartiles({40, 10, 30, 20});  // numpy.percentile gives 17.5, 25, 32.5
  EXPECT_DOUBLE_EQ(even.q1, 17.5);
  EXPECT_DOUBLE_EQ(even.median, 25);
  EXPECT_DOUBLE_EQ(even.q3, 32.5);
  const Quartiles one = quartiles({7});
  EXPECT_DOUBLE_EQ(one.q1, 7);
  EXPECT_DOUBLE_EQ(one.q3, 7);
}

TEST(Statistics, GeometricMeanOfARatioAndItsInverseIsOne) {
  EXPECT_DOUBLE_EQ(geometric_mean({4, 0.25}), 1);
  EXPECT_NEAR(geometric_mean({1, 2, 4}), 2, 1e-12);
}

}  // namespace
}  // namespace ps::statistics_test
