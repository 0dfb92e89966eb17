// Four numbers for each lane, turned into four vectors; compiled once for each SIMD target (Highway). Without a detour
// through memory, where a vector would have to wait for the quarters that were written just before.
#if defined(PIXELSCOPE_MATH_QUARTERS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELSCOPE_MATH_QUARTERS_INL_H_
#undef PIXELSCOPE_MATH_QUARTERS_INL_H_
#else
#define PIXELSCOPE_MATH_QUARTERS_INL_H_
#endif

#include <type_traits>

#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace ps::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using FloatLanes = hn::ScalableTag<float>;

/// make(first), and so on every fourth lane, side by side.
template <class Make>
HWY_INLINE hn::Vec<FloatLanes> every_fourth(const Make& make, std::size_t first) {
#if HWY_MAX_BYTES == 16
  return make(first);
#else
  const hn::FixedTag<float, 8> two;
  const auto low = hn::Combine(two, make(first + 4), make(first));
#if HWY_MAX_BYTES == 32
  return low;
#else
  return hn::Combine(FloatLanes(), hn::Combine(two, make(first + 12), make(first + 8)), low);
#endif
#endif
}

struct FourVectors {
  hn::Vec<FloatLanes> first, second, third, fourth;
};

/// The first ones of four numbers for each lane, the second ones and so on. `a` holds all four of lanes 0, 4, 8, ...,
/// `b` those of 1, 5, 9, ..., and so on, as every_fourth() puts them.
HWY_INLINE FourVectors turn_quarters(hn::Vec<FloatLanes> a, hn::Vec<FloatLanes> b, hn::Vec<FloatLanes> c,
                                     hn::Vec<FloatLanes> e) {
  const FloatLanes d;
  const hn::Repartition<double, FloatLanes> pairs;
  const auto low_ab = hn::BitCast(pairs, hn::InterleaveLower(d, a, b));
  const auto low_ce = hn::BitCast(pairs, hn::InterleaveLower(d, c, e));
  const auto high_ab = hn::BitCast(pairs, hn::InterleaveUpper(d, a, b));
  const auto high_ce = hn::BitCast(pairs, hn::InterleaveUpper(d, c, e));
  return {hn::BitCast(d, hn::InterleaveLower(pairs, low_ab, low_ce)),
          hn::BitCast(d, hn::InterleaveUpper(pairs, low_ab, low_ce)),
          hn::BitCast(d, hn::InterleaveLower(pairs, high_ab, high_ce)),
          hn::BitCast(d, hn::InterleaveUpper(pairs, high_ab, high_ce))};
}

/// Number 0, 1, 2 and 3 of what make(i), a vector of four floats, gives for each lane i.
template <class Make>
HWY_INLINE FourVectors four_vectors(Make&& make) {
  return turn_quarters(every_fourth(make, 0), every_fourth(make, 1), every_fourth(make, 2), every_fourth(make, 3));
}

/// The same where make(k) gives whole vectors as turn_quarters() takes them, k being a constant.
template <class Make>
HWY_INLINE FourVectors four_vectors_of_quarters(Make&& make) {
  return turn_quarters(make(std::integral_constant<int, 0>()), make(std::integral_constant<int, 1>()),
                       make(std::integral_constant<int, 2>()), make(std::integral_constant<int, 3>()));
}

}  // namespace ps::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
