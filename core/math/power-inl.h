// Vector form of math/power.h, compiled once for each SIMD target (Highway). Same operations in the same order for each
// lane, so the same bits.
#if defined(PIXELSCOPE_POWER_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELSCOPE_POWER_INL_H_
#undef PIXELSCOPE_POWER_INL_H_
#else
#define PIXELSCOPE_POWER_INL_H_
#endif

#include <cstdint>
#include <limits>

#include "hwy/highway.h"
#include "math/power.h"

HWY_BEFORE_NAMESPACE();
namespace ps::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// series * z + next, rounded twice.
template <class V>
HWY_INLINE V step(V series, V z, V next) {
  return hn::Add(hn::Mul(series, z), next);
}

/// power_detail::power_positive for a vector of doubles that came from floats.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V power_of_doubles(D d, V x, V y) {
  using power_detail::round_to_integer;
  const hn::Rebind<std::int64_t, D> di;
  const auto bits = hn::BitCast(di, x);
  const auto exponent =
      hn::ShiftRight<52>(hn::Sub(bits, hn::Set(di, static_cast<std::int64_t>(power_detail::sqrt_half_bits))));
  const V mantissa = hn::BitCast(d, hn::Sub(bits, hn::ShiftLeft<52>(exponent)));
  // A small whole number as a double: placed in the low bits of 1.5 * 2^52, which is then taken away.
  const V magic = hn::Set(d, round_to_integer);
  const V whole = hn::Sub(hn::BitCast(d, hn::Add(exponent, hn::BitCast(di, magic))), magic);
  const V one = hn::Set(d, 1.0);
  const V s = hn::Div(hn::Sub(mantissa, one), hn::Add(mantissa, one));
  const V z = hn::Mul(s, s);
  V series = hn::Set(d, 1.0 / 15.0);
  series = step(series, z, hn::Set(d, 1.0 / 13.0));
  series = step(series, z, hn::Set(d, 1.0 / 11.0));
  series = step(series, z, hn::Set(d, 1.0 / 9.0));
  series = step(series, z, hn::Set(d, 1.0 / 7.0));
  series = step(series, z, hn::Set(d, 1.0 / 5.0));
  series = step(series, z, hn::Set(d, 1.0 / 3.0));
  series = step(series, z, one);
  const V log2_x = hn::Add(whole, hn::Mul(hn::Mul(hn::Set(d, power_detail::two_over_ln2), s), series));
  V p = hn::Mul(y, log2_x);
  const V limit = hn::Set(d, 1000.0);
  p = hn::IfThenElse(hn::Lt(p, limit), p, limit);
  p = hn::IfThenElse(hn::Gt(p, hn::Neg(limit)), p, hn::Neg(limit));
  const V shifted = hn::Add(p, magic);
  const V n = hn::Sub(shifted, magic);
  const V r = hn::Mul(hn::Sub(p, n), hn::Set(d, power_detail::ln2));
  V e = hn::Set(d, 1.0 / 362880.0);
  e = step(e, r, hn::Set(d, 1.0 / 40320.0));
  e = step(e, r, hn::Set(d, 1.0 / 5040.0));
  e = step(e, r, hn::Set(d, 1.0 / 720.0));
  e = step(e, r, hn::Set(d, 1.0 / 120.0));
  e = step(e, r, hn::Set(d, 1.0 / 24.0));
  e = step(e, r, hn::Set(d, 1.0 / 6.0));
  e = step(e, r, hn::Set(d, 0.5));
  e = step(e, r, one);
  e = step(e, r, one);
  const auto n_bits = hn::Sub(hn::BitCast(di, shifted), hn::BitCast(di, magic));
  const V scale = hn::BitCast(d, hn::ShiftLeft<52>(hn::Add(n_bits, hn::Set(di, std::int64_t{1023}))));
  return hn::Mul(e, scale);
}

/// power(x, y) for floats x >= 0 and finite y > 0.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V power_of_floats(D d, V x, V y) {
  const hn::Half<D> half;
  const hn::Repartition<double, D> wide;
  const auto part = [&](auto px, auto py) HWY_ATTR {
    return hn::DemoteTo(half, power_of_doubles(wide, hn::PromoteTo(wide, px), hn::PromoteTo(wide, py)));
  };
  const auto low = part(hn::LowerHalf(half, x), hn::LowerHalf(half, y));
  const auto high = part(hn::UpperHalf(half, x), hn::UpperHalf(half, y));
  V result = hn::Combine(d, high, low);
  const V infinity = hn::Set(d, std::numeric_limits<float>::infinity());
  result = hn::IfThenZeroElse(hn::Eq(x, hn::Zero(d)), result);
  result = hn::IfThenElse(hn::Eq(x, infinity), infinity, result);
  return hn::IfThenElse(hn::Eq(x, x), result, hn::Set(d, std::numeric_limits<float>::quiet_NaN()));
}

}  // namespace ps::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
