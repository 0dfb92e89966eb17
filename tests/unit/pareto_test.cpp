#include "study/pareto.h"
#include "support/seeded_random.h"

#include <cmath>

#include <gtest/gtest.h>

namespace ps::pareto_test {
namespace {

/// By the definition: nobody else is at least as good in both and better in one.
std::vector<bool> by_definition(const std::vector<Tradeoff>& points) {
  std::vector<bool> front(points.size(), true);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (std::isnan(points[i].cost) || std::isnan(points[i].error)) front[i] = false;
    for (const Tradeoff& other : points)
      if (other.cost <= points[i].cost && other.error <= points[i].error &&
          (other.cost < points[i].cost || other.error < points[i].error))
        front[i] = false;
  }
  return front;
}

TEST(Pareto, MatchesTheDefinitionOnRandomPointsWithManyTies) {
  test::SeededRandom random;
  for (int round = 0; round < 2000; ++round) {
    std::vector<Tradeoff> points(random() % 13);
    for (Tradeoff& point : points) point = {static_cast<double>(random() % 5), static_cast<double>(random() % 5)};
    for (Tradeoff& point : points)
      if (random() % 40 == 0) point.error = random() % 2 == 0 ? NAN : INFINITY;
    EXPECT_EQ(pareto_front(points), by_definition(points));
  }
}

TEST(Pareto, OnePointAndEqualPointsAreTheFront) {
  EXPECT_EQ(pareto_front(std::vector<Tradeoff>{{1, 1}}), std::vector<bool>({true}));
  EXPECT_EQ(pareto_front(std::vector<Tradeoff>{{1, 1}, {1, 1}, {1, 2}}), std::vector<bool>({true, true, false}));
  EXPECT_EQ(pareto_front(std::vector<Tradeoff>{{1, INFINITY}, {2, INFINITY}}), std::vector<bool>({true, false}));
}

}  // namespace
}  // namespace ps::pareto_test
