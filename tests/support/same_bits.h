#pragma once
#include <cstring>

#include "image/image.h"

namespace ps::test {

/// Whether two images have the same size and the same bits; NaN equals itself, and +0 differs from -0.
template <class T>
bool same_bits(const Image<T>& a, const Image<T>& b) {
  if (a.width() != b.width() || a.height() != b.height()) return false;
  return a.empty() || std::memcmp(a.pixels().data(), b.pixels().data(), a.pixels().size_bytes()) == 0;
}

}  // namespace ps::test
