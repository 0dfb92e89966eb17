#include <array>

#include "accel/slab.h"
#include "study/stability/support.h"

namespace ps::stability::slab_tests {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

struct Case {
  Box<float> box;
  Vec3f origin, direction;
};

/// Rays from around a box of three, two or one dimensions towards a point on one of its edges.
Case aimed_case(int dimensions, Random& random) {
  Case result;
  Vec3f low, high, target;
  for (int axis = 0; axis < 3; ++axis) {
    low[axis] = static_cast<float>(random.between(-1, 1));
    high[axis] = low[axis] + static_cast<float>(random.unit());
  }
  const int first = static_cast<int>(random.below(3));
  for (int i = dimensions; i < 3; ++i) high[(first + i) % 3] = low[(first + i) % 3];
  const int along = static_cast<int>(random.below(3));
  for (int axis = 0; axis < 3; ++axis) target[axis] = random.coin() ? low[axis] : high[axis];
  target[along] = static_cast<float>(random.between(low[along], high[along]));
  result.box = {low, high};
  for (int axis = 0; axis < 3; ++axis) result.origin[axis] = static_cast<float>(random.between(-4, 4));
  result.direction = target - result.origin;
  return result;
}

SlabRange<float> range_of(const Case& c, SlabForm form) {
  return slab_test(SlabRay<float>(c.origin, c.direction, 0, form), c.box, infinity);
}
bool robust(const Case& c) { return range_of(c, SlabForm::robust).hit(); }

/// How the ends of the program's naive range are compared. The program has the closed form alone; the others are usual
/// variants: `strict` loses what is flat, and a far end moved by one or two representable numbers makes up for the
/// rounding (Ize, JCGT 2013).
enum class Ending { closed, strict, one_ulp, two_ulps };

bool naive(const Case& c, Ending ending) {
  const auto [near, far] = range_of(c, SlabForm::naive);
  switch (ending) {
  case Ending::closed:
    return near <= far;
  case Ending::strict:
    return near < far;
  case Ending::one_ulp:
    return near <= std::nextafter(far, infinity);
  case Ending::two_ulps:
    return near <= std::nextafter(std::nextafter(far, infinity), infinity);
  }
  return false;
}

/// Whether the line meets the box, by comparing products instead of quotients in long double.
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

void measure_false_miss(const StabilityRun& run, Rows& rows) {
  for (const int dimensions : {3, 2, 1}) {
    run.check();
    Random random(run.seed);
    double met = 0, lost = 0;
    std::array<double, 4> missed_by{};  // in the order of the endings
    const int rays = run.count(1000000, 100000);
    for (int i = 0; i < rays; ++i) {
      const Case c = aimed_case(dimensions, random);
      if (!meets(c)) continue;
      ++met;
      for (std::size_t k = 0; k < missed_by.size(); ++k) missed_by[k] += naive(c, static_cast<Ending>(k)) ? 0 : 1;
      lost += robust(c) ? 0 : 1;
    }
    const char* names[] = {"near <= far", "near < far", "near <= far + 1 ulp", "near <= far + 2 ulps"};
    for (std::size_t i = 0; i < missed_by.size(); ++i)
      rows.add(dimensions, names[i], per_million(missed_by[i], met), per_million(lost, met),
               "false misses per million");
  }
}

/// Which zeros the directions have, and in how many sides' planes the rays run.
struct PlaneRays {
  bool positive_zeros = true, negative_zeros = true;
  int sides = 1;
};

/// Rays along an axis that run in the plane of a side: (plane - origin) / 0 is 0 times infinity there.
template <class Combine>
double missed(const PlaneRays& rays, const Combine& combine) {
  double all = 0, lost = 0;
  const float inside = rays.sides == 2 ? 1.0f : 0.5f;
  for (int axis = 0; axis < 3; ++axis)
    for (const float way : {1.0f, -1.0f})
      for (const float first : {-1.0f, 1.0f})
        for (const float second : {-inside, inside})
          for (const float zero_a : {0.0f, -0.0f})
            for (const float zero_b : {0.0f, -0.0f}) {
              const bool negative = std::signbit(zero_a) || std::signbit(zero_b);
              const bool positive = !std::signbit(zero_a) || !std::signbit(zero_b);
              if ((negative && !rays.negative_zeros) || (positive && !rays.positive_zeros)) continue;
              Case c{{{-1, -1, -1}, {1, 1, 1}}, Vec3f(0), Vec3f(0)};
              const int a = (axis + 1) % 3, b = (axis + 2) % 3;
              c.origin[axis] = -3 * way, c.direction[axis] = way;
              c.origin[a] = first, c.origin[b] = second;
              c.direction[a] = zero_a, c.direction[b] = zero_b;
              ++all;
              lost += combine(c) ? 0 : 1;
            }
  return percent(lost, all);
}

/// Two more ways to write the slab test, which Pixelscope does not have: `combine` takes the sorted t of each axis into
/// near and far.
template <class Sort, class Combine>
bool slabs(const Case& c, Sort sort, Combine combine) {
  float near = 0, far = infinity;
  for (int axis = 0; axis < 3; ++axis) {
    const float inverse = 1 / c.direction[axis];
    float t0 = (c.box.low[axis] - c.origin[axis]) * inverse, t1 = (c.box.high[axis] - c.origin[axis]) * inverse;
    sort(t0, t1);
    combine(t0, t1, near, far);
  }
  return near <= far;
}

void measure_nan_slab(const StabilityRun&, Rows& rows) {
  const auto new_first = [](const Case& c) { return naive(c, Ending::closed); };
  const auto old_first = [](const Case& c) {
    const auto by_min_max = [](float& t0, float& t1) {
      const float low = std::min(t0, t1), high = std::max(t0, t1);
      t0 = low, t1 = high;
    };
    return slabs(c, by_min_max, [](float t0, float t1, float& near, float& far) {
      near = std::max(near, t0), far = std::min(far, t1);
    });
  };
  const auto swap_if = [](const Case& c) {  // the usual code for Kay and Kajiya 1986
    const auto by_swap = [](float& t0, float& t1) {
      if (t0 > t1) std::swap(t0, t1);
    };
    return slabs(c, by_swap, [](float t0, float t1, float& near, float& far) {
      if (t0 > near) near = t0;
      if (t1 < far) far = t1;
    });
  };
  const auto add = [&](double knob, const char* series, const PlaneRays& rays, const auto& combine) {
    rows.add(knob, series, missed(rays, combine), missed(rays, robust), "% of touched boxes missed");
  };
  add(0, "max(t0, near), in the planes of two sides", {true, true, 2}, new_first);
  add(0, "max(t0, near), in the plane of one side", {}, new_first);
  add(0, "max(near, t0), in the planes of two sides", {true, true, 2}, old_first);
  add(0, "max(near, t0), in the plane of one side", {}, old_first);
  add(1, "swap if t0 > t1, direction +0", {true, false, 2}, swap_if);
  add(-1, "swap if t0 > t1, direction -0", {false, true, 2}, swap_if);
}

}  // namespace

extern const StabilityExperiment slab_test_false_miss{
    .key = "slab-test-false-miss",
    .place = {Subject::boxes, 10},
    .title = "Slab test: boxes missed at their edges",
    .keywords = "ray box, AABB, bounding box, BVH, rounding",
    .knob = "shape of the box",
    .naive = "near <= far, as computed (slab-test = naive)",
    .robust = "far end grown by its rounding error, 2 gamma(3) (slab-test = robust)",
    .explanation = "A ray at an edge of a box enters through one plane and leaves through another at the same t, which "
                   "is rounded twice. The flatter the box, the more of its rays do.",
    .safe = "Nowhere for boxes that touch.",
    .window = nowhere_safe,
    .series = {{.names = "near <= far|*",
                .title = "boxes missed by rays that meet them",
                .unit = "per million",
                .cases = {{3, "solid box"}, {2, "rectangle"}, {1, "line"}}}},
    .add_rows = measure_false_miss};

extern const StabilityExperiment zero_inf_nan_slab{
    .key = "0-inf-nan-slab",
    .place = {Subject::boxes, 30},
    .title = "Slab test: 0 times infinity",
    .keywords = "NaN, infinity, ray box, AABB, division by zero",
    .knob = "sign of the zero components of the direction (0 = both)",
    .naive = "min and max, with one order of operands or the other",
    .robust = "planes in the order of the ray, comparisons false for NaN (slab-test = robust)",
    .explanation = "A ray in the plane of a side is at distance 0 from it, and its inverse direction is infinite: 0 "
                   "times infinity is NaN. std::max(a, b) returns a if either is NaN, so the order of operands decides "
                   "which boxes are lost.",
    .safe = "Directions without a zero component.",
    .window = nowhere_safe,
    .series = {{.names = "*", .title = "touched boxes that are missed", .unit = "%"}},
    .add_rows = measure_nan_slab};

}  // namespace ps::stability::slab_tests
