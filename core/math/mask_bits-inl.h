// A mask's lanes as the bits of a number; compiled once for each SIMD target (Highway).
#if defined(PIXELSCOPE_MATH_MASK_BITS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELSCOPE_MATH_MASK_BITS_INL_H_
#undef PIXELSCOPE_MATH_MASK_BITS_INL_H_
#else
#define PIXELSCOPE_MATH_MASK_BITS_INL_H_
#endif

#include <array>
#include <cstdint>

#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace ps::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Bit i of the result is lane i of the mask.
template <class D>
HWY_INLINE std::uint64_t bits_of(D d, hn::Mask<D> mask) {
  std::array<std::uint8_t, 8> bytes{};
  hn::StoreMaskBits(d, mask, bytes.data());
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < (hn::MaxLanes(D()) + 7) / 8; ++i) bits |= std::uint64_t{bytes[i]} << (8 * i);
  return bits;
}

}  // namespace ps::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
