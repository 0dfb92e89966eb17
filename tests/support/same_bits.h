#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <type_traits>

#include "image/image.h"

namespace ps::test {

/// Whether two images have the same size and the same bits; NaN equals itself, and +0 differs from -0.
template <class T>
bool same_bits(const Image<T>& a, const Image<T>& b) {
  if (a.width() != b.width() || a.height() != b.height()) return false;
  return a.empty() || std::memcmp(a.pixels().data(), b.pixels().data(), a.pixels().size_bytes()) == 0;
}

/// The same of two numbers.
template <std::floating_point Real>
bool same_bits(Real a, Real b) {
  using Bits = std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t>;
  return std::bit_cast<Bits>(a) == std::bit_cast<Bits>(b);
}

template <std::floating_point Real, std::size_t count>
bool same_bits(const std::array<Real, count>& a, const std::array<Real, count>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), [](Real x, Real y) { return same_bits(x, y); });
}

}  // namespace ps::test
