// How often a random test tries: as written, or fewer times under a sanitizer, where each try costs ten times as much
// and one is as good as many at showing a bad access. What a test proves about values is proved by the Release build.
#pragma once

#include <algorithm>
#include <cstddef>

#include "base/sanitizers.h"

namespace ps::test {

inline constexpr int trial_divisor = with_address_sanitizer || with_thread_sanitizer ? 8 : 1;

/// `count` tries, an eighth of them (at least one) under a sanitizer.
constexpr int trials(int count) { return std::max(1, count / trial_divisor); }

/// The elements of a list to try: each one, or every fourth under a sanitizer.
inline constexpr std::size_t list_step = trial_divisor > 1 ? 4 : 1;

/// The side of a picture in pixels: as written, or half of it (a quarter of the pixels) under a sanitizer.
constexpr int side(int pixels) { return trial_divisor > 1 ? pixels / 2 : pixels; }

/// A number of pixels in a picture with such sides.
constexpr int area(int pixels) { return trial_divisor > 1 ? pixels / 4 : pixels; }

}  // namespace ps::test
