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

void display_levels(const float* values, std::size_t count, double exposure, std::uint8_t* levels) {
  const hn::ScalableTag<double> d;
  const hn::Rebind<float, decltype(d)> single;
  const hn::Rebind<std::uint64_t, decltype(d)> bits;
  const hn::Rebind<std::uint8_t, decltype(d)> bytes;
  const auto zero = hn::Zero(d);
  const auto factor = hn::Set(d, exposure);
  const auto highest = hn::Set(d, 255.0);
  const auto convert = [&](auto value) HWY_ATTR {
    const auto level = hn::Mul(hn::Mul(hn::PromoteTo(d, value), factor), highest);
    const auto low = hn::IfThenElse(hn::Lt(level, highest), level, highest);
    const auto clamped = hn::IfThenElse(hn::Gt(level, zero), low, zero);
    // Adding 2^52 leaves no bits behind the point; the rounded number is in the low bits.
    return hn::TruncateTo(bytes, hn::BitCast(bits, hn::Add(clamped, hn::Set(d, 0x1p52))));
  };
  const std::size_t lanes = hn::Lanes(d);
  std::size_t i = 0;
  for (; i + lanes <= count; i += lanes) hn::StoreU(convert(hn::LoadU(single, values + i)), bytes, levels + i);
  if (i == count) return;
  HWY_ALIGN float rest[HWY_MAX_BYTES / sizeof(float)] = {};
  HWY_ALIGN std::uint8_t converted[HWY_MAX_BYTES];
  std::copy(values + i, values + count, rest);
  hn::StoreU(convert(hn::LoadU(single, rest)), bytes, converted);
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
