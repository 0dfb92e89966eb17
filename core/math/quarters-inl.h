// Four numbers for each lane, turned into four vectors; compiled once for each SIMD target (Highway). Without a detour
// through memory, where a vector would have to wait for the quarters that were written just before.
#if defined(PIXELSCOPE_MATH_QUARTERS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELSCOPE_MATH_QUARTERS_INL_H_
#undef PIXELSCOPE_MATH_QUARTERS_INL_H_
#else
#define PIXELSCOPE_MATH_QUARTERS_INL_H_
#endif

#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace ps::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using FloatLanes = hn::ScalableTag<float>;

/// make(first), and so on every fourth lane, side by side.
template <class Make>
HWY_INLINE hn::Vec<FloatLanes> every_fourth(Make& make, std::size_t first) {
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

/// Number 0, 1, 2 and 3 of what make(i), a vector of four floats, gives for each lane i.
struct FourVectors {
  hn::Vec<FloatLanes> first, second, third, fourth;
};
template <class Make>
HWY_INLINE FourVectors four_vectors(Make&& make) {
  const FloatLanes d;
  const hn::Repartition<double, FloatLanes> pairs;
  const auto a = every_fourth(make, 0), b = every_fourth(make, 1), c = every_fourth(make, 2), e = every_fourth(make, 3);
  const auto low_ab = hn::BitCast(pairs, hn::InterleaveLower(d, a, b));
  const auto low_ce = hn::BitCast(pairs, hn::InterleaveLower(d, c, e));
  const auto high_ab = hn::BitCast(pairs, hn::InterleaveUpper(d, a, b));
  const auto high_ce = hn::BitCast(pairs, hn::InterleaveUpper(d, c, e));
  return {hn::BitCast(d, hn::InterleaveLower(pairs, low_ab, low_ce)),
          hn::BitCast(d, hn::InterleaveUpper(pairs, low_ab, low_ce)),
          hn::BitCast(d, hn::InterleaveLower(pairs, high_ab, high_ce)),
          hn::BitCast(d, hn::InterleaveUpper(pairs, high_ab, high_ce))};
}

}  // namespace ps::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
