#include "image/display_levels.h"

#include <algorithm>

// This file is compiled once for each SIMD target.
#undef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS HWY_SSSE3
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "image/display_levels.cpp"
#include "hwy/foreach_target.h"  // IWYU pragma: keep
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace ps::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

namespace {

using D = hn::ScalableTag<float>;
using Levels = hn::Rebind<std::uint8_t, D>;

/// In double, as display_pixel does it.
HWY_INLINE void convert_exactly(const float* values, double exposure, std::uint8_t* levels) {
  const hn::ScalableTag<double> d;
  const hn::Rebind<float, decltype(d)> single;
  const hn::Rebind<std::uint64_t, decltype(d)> bits;
  const hn::Rebind<std::uint8_t, decltype(d)> bytes;
  const auto highest = hn::Set(d, 255.0);
  for (std::size_t i = 0; i < hn::Lanes(D()); i += hn::Lanes(d)) {
    const auto value = hn::PromoteTo(d, hn::LoadU(single, values + i));
    const auto level = hn::Mul(hn::Mul(value, hn::Set(d, exposure)), highest);
    const auto low = hn::IfThenElse(hn::Lt(level, highest), level, highest);
    const auto clamped = hn::IfThenElse(hn::Gt(level, hn::Zero(d)), low, hn::Zero(d));
    // Adding 2^52 leaves no bits behind the point; the rounded number is in the low bits.
    hn::StoreU(hn::TruncateTo(bytes, hn::BitCast(bits, hn::Add(clamped, hn::Set(d, 0x1p52)))), bytes, levels + i);
  }
}

#if HWY_TARGET <= HWY_AVX2
/// Without an exposure float is enough where product and sum are rounded once: 2^23 leaves no bits behind the point,
/// so that is the rounding to a whole number, and the number is in the low bits.
HWY_INLINE void convert(const float* values, double exposure, std::uint8_t* levels) {
  const D d;
  const hn::Rebind<std::uint32_t, D> bits;
  if (exposure != 1) return convert_exactly(values, exposure, levels);
  const auto value = hn::LoadU(d, values), one = hn::Set(d, 1.0f);
  const auto low = hn::IfThenElseZero(hn::Gt(value, hn::Zero(d)), value);
  const auto clamped = hn::IfThenElse(hn::Lt(low, one), low, one);
  const auto rounded = hn::MulAdd(clamped, hn::Set(d, 255.0f), hn::Set(d, 0x1p23f));
  hn::StoreU(hn::TruncateTo(Levels(), hn::BitCast(bits, rounded)), Levels(), levels);
}
#else
/// Without an exposure float is enough but for ties: rounding the product to float keeps it on its side of every half,
/// or moves it onto the half, of which the exact product then decides.
HWY_INLINE void convert(const float* values, double exposure, std::uint8_t* levels) {
  const D d;
  if (exposure != 1) return convert_exactly(values, exposure, levels);
  const auto highest = hn::Set(d, 255.0f);
  const auto level = hn::Mul(hn::LoadU(d, values), highest);
  const auto low = hn::IfThenElse(hn::Lt(level, highest), level, highest);
  const auto clamped = hn::IfThenElse(hn::Gt(level, hn::Zero(d)), low, hn::Zero(d));
  const auto rounded = hn::NearestInt(clamped);
  const auto moved = hn::Abs(hn::Sub(hn::ConvertTo(d, rounded), clamped));
  if (!hn::AllFalse(d, hn::Eq(moved, hn::Set(d, 0.5f)))) return convert_exactly(values, exposure, levels);
  hn::StoreU(hn::DemoteTo(Levels(), rounded), Levels(), levels);
}
#endif

}  // namespace

void display_levels(const float* values, std::size_t count, double exposure, std::uint8_t* levels) {
  const std::size_t lanes = hn::Lanes(D());
  std::size_t i = 0;
  for (; i + lanes <= count; i += lanes) convert(values + i, exposure, levels + i);
  if (i == count) return;
  HWY_ALIGN float rest[hn::MaxLanes(D())] = {};
  HWY_ALIGN std::uint8_t converted[hn::MaxLanes(D())];
  std::copy(values + i, values + count, rest);
  convert(rest, exposure, converted);
  std::copy(converted, converted + (count - i), levels + i);
}

}  // namespace ps::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ps {

HWY_EXPORT(display_levels);
void display_levels(const float* values, std::size_t count, double exposure, std::uint8_t* levels) {
  HWY_DYNAMIC_DISPATCH(display_levels)(values, count, exposure, levels);
}

}  // namespace ps
#endif
