// How often a box is missed by a ray aimed at one of its edges, for the slab test of the program and for the usual
// variants (stability rows 13 and 15). long double decides what a ray meets.
#include <gtest/gtest.h>

#include <iostream>
#include <random>

#include "accel/slab.h"

namespace slab_rates_test {
namespace {

using namespace ps;

constexpr unsigned seed = 20262;
constexpr float infinity = std::numeric_limits<float>::infinity();

struct Case {
  Box<float> box;
  Vec3f origin, direction;
};

/// Rays from around a box of three, two or one dimensions towards a point on one of its edges.
Case aimed_case(int dimensions, std::mt19937_64& random) {
  const auto unit = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  Case result;
  Vec3f low, high, target;
  for (int axis = 0; axis < 3; ++axis) {
    low[axis] = static_cast<float>(2 * unit() - 1);
    high[axis] = low[axis] + static_cast<float>(unit());
  }
  const int first = static_cast<int>(random() % 3);
  for (int i = dimensions; i < 3; ++i) high[(first + i) % 3] = low[(first + i) % 3];
  const int along = static_cast<int>(random() % 3);
  for (int axis = 0; axis < 3; ++axis) target[axis] = random() % 2 == 0 ? low[axis] : high[axis];
  target[along] = static_cast<float>(static_cast<double>(low[along]) +
                                     unit() * (static_cast<double>(high[along]) - static_cast<double>(low[along])));
  result.box = {low, high};
  for (int axis = 0; axis < 3; ++axis) result.origin[axis] = static_cast<float>(8 * unit() - 4);
  result.direction = target - result.origin;
  return result;
}

enum class Ends { closed, open };

/// The slab test as it is usually written, in any precision.
template <class Real>
bool textbook(const Case& c, Ends ends) {
  Real near = 0, far = std::numeric_limits<Real>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    const Real inverse = Real(1) / static_cast<Real>(c.direction[axis]);
    const Real t0 = (static_cast<Real>(c.box.low[axis]) - static_cast<Real>(c.origin[axis])) * inverse;
    const Real t1 = (static_cast<Real>(c.box.high[axis]) - static_cast<Real>(c.origin[axis])) * inverse;
    near = std::max(near, std::min(t0, t1));
    far = std::min(far, std::max(t0, t1));
  }
  return ends == Ends::closed ? near <= far : near < far;
}

/// Without rounding of the quotients: whether the line meets the box, by comparing products in long double.
bool meets(const Case& c) {
  long double near_num = 0, near_den = 1, far_num = 1, far_den = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const long double d = c.direction[axis], o = c.origin[axis];
    if (d == 0) continue;
    const long double low = static_cast<long double>(c.box.low[axis]) - o;
    const long double high = static_cast<long double>(c.box.high[axis]) - o;
    const long double sign = d < 0 ? -1 : 1;
    const long double enter = sign * (d < 0 ? high : low), leave = sign * (d < 0 ? low : high), size = sign * d;
    if (enter * near_den > near_num * size) near_num = enter, near_den = size;
    if (leave * far_den < far_num * size) far_num = leave, far_den = size;
  }
  return near_num * far_den <= far_num * near_den;
}

TEST(SlabRates, NoBoxIsMissedWhereTextbookTestsMissMany) {
  struct Row {
    const char* name;
    int dimensions;
    double closed, open;  // false misses per million elsewhere
  };
  constexpr int rays = 300'000;
  for (const Row& row :
       {Row{"solid", 3, 41'880, 307'189}, Row{"flat", 2, 138'342, 1e6}, Row{"needle", 1, 289'814, 1e6}}) {
    std::mt19937_64 random(seed);
    int met = 0, closed = 0, open = 0, robust = 0;
    for (int i = 0; i < rays; ++i) {
      const Case c = aimed_case(row.dimensions, random);
      if (!meets(c)) continue;
      ++met;
      closed += textbook<float>(c, Ends::closed) ? 0 : 1;
      open += textbook<float>(c, Ends::open) ? 0 : 1;
      robust += slab_test(SlabRay<float>(c.origin, c.direction, 0), c.box, infinity).hit() ? 0 : 1;
    }
    const auto per_million = [&](int count) { return 1e6 * count / met; };
    std::cout << row.name << ": of " << met << " rays that meet the box, per million: textbook misses "
              << per_million(closed) << ", strict " << per_million(open) << ", robust " << per_million(robust)
              << " (seed " << seed << ")\n";
    EXPECT_GT(met, rays / 20);
    EXPECT_EQ(robust, 0);
    for (const auto& [actual, elsewhere] : {std::pair(closed, row.closed), std::pair(open, row.open)}) {
      EXPECT_GT(per_million(actual), elsewhere / 1.5);
      EXPECT_LT(per_million(actual), elsewhere * 1.5);
    }
  }
}

/// Rays along an axis that start in the plane of a side: 0 * infinity. Which operand of min and max is the NaN decides.
template <class Combine>
int missed_in_planes(Combine combine) {
  int missed = 0;
  for (const float zero_x : {0.0f, -0.0f})
    for (const float zero_y : {0.0f, -0.0f})
      for (const float x : {-1.0f, 1.0f})
        for (const float y : {-1.0f, 0.0f, 1.0f})
          for (const float z : {1.0f, -1.0f})
            missed += combine(Case{{{-1, -1, -1}, {1, 1, 1}}, {x, y, -3 * z}, {zero_x, zero_y, z}}) ? 0 : 1;
  return missed;
}

TEST(SlabRates, RaysInThePlaneOfASideMeetTheBox) {
  EXPECT_EQ(missed_in_planes([](const Case& c) {
              return slab_test(SlabRay<float>(c.origin, c.direction, 0), c.box, infinity).hit();
            }),
            0);
  const int naive = missed_in_planes([](const Case& c) {
    float near = 0, far = infinity;
    for (int axis = 0; axis < 3; ++axis) {
      const float inverse = 1 / c.direction[axis];
      float t0 = (c.box.low[axis] - c.origin[axis]) * inverse, t1 = (c.box.high[axis] - c.origin[axis]) * inverse;
      if (inverse < 0) std::swap(t0, t1);
      near = t0 > near || t0 != t0 ? t0 : near;  // a maximum that hands a NaN on
      far = t1 < far || t1 != t1 ? t1 : far;
    }
    return near <= far;
  });
  EXPECT_EQ(naive, 48) << "every one of these rays lies in a side's plane";
}

}  // namespace
}  // namespace slab_rates_test
