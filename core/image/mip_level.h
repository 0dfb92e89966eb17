#pragma once
#include <bit>
#include <cstdint>
#include <type_traits>

#include "math/vec.h"

namespace ps {

/// How far texture coordinates move from one pixel to the next, in texels of level 0.
template <class Real>
struct TextureDerivatives {
  Vec2<Real> dx{0, 0};  ///< (du/dx * width, dv/dx * height): one pixel to the right
  Vec2<Real> dy{0, 0};  ///< (du/dy * width, dv/dy * height): one pixel down
};

/// Base-2 logarithm of a positive finite number: 2^k * m with m in [sqrt(1/2), sqrt(2)) gives k plus the series of
/// 2/ln 2 * artanh((m - 1) / (m + 1)). Exact for powers of two, otherwise within 1e-6 (float) and 1e-9 (double); plain
/// operations in a fixed order, so every processor gets the same bits. 0 gives a large negative number.
template <class Real>
inline Real level_log2(Real value) {
  constexpr bool single = sizeof(Real) == 4;
  using Bits = std::conditional_t<single, std::int32_t, std::int64_t>;
  constexpr int mantissa_bits = single ? 23 : 52;
  constexpr Bits root_half = single ? Bits{0x3f3504f3} : static_cast<Bits>(0x3fe6a09e667f3bcd);
  const Bits bits = std::bit_cast<Bits>(value);
  const Bits exponent = (bits - root_half) >> mantissa_bits;
  const Real mantissa = std::bit_cast<Real>(static_cast<Bits>(bits - exponent * (Bits{1} << mantissa_bits)));
  const Real q = (mantissa - Real(1)) / (mantissa + Real(1));
  const Real s = q * q;
  Real sum = Real(1) / Real(7);
  if constexpr (!single) {
    sum = Real(1) / Real(11);
    sum = sum * s + Real(1) / Real(9);
    sum = sum * s + Real(1) / Real(7);
  }
  sum = sum * s + Real(1) / Real(5);
  sum = sum * s + Real(1) / Real(3);
  sum = sum * s + Real(1);
  constexpr Real two_over_ln2 = static_cast<Real>(2.8853900817779268147);
  return static_cast<Real>(exponent) + q * sum * two_over_ln2;
}

/// Level of detail at which one texel is about as large as one pixel (CGFS ch. 14): log2 of the longer of the two
/// steps, plus the bias. Not clamped; negative where the texture is magnified. 1/2 log2 of the squared length saves the
/// root.
template <class Real>
inline Real mip_level(const TextureDerivatives<Real>& derivatives, Real bias = 0) {
  const Real x = derivatives.dx.x * derivatives.dx.x + derivatives.dx.y * derivatives.dx.y;
  const Real y = derivatives.dy.x * derivatives.dy.x + derivatives.dy.y * derivatives.dy.y;
  const Real longer = x > y ? x : y;
  return Real(0.5) * level_log2(longer) + bias;
}

}  // namespace ps
