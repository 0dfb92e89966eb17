#pragma once
#include <cstddef>
#include <optional>

#include "image/image.h"
#include "math/vec.h"

namespace ps {

/// Where a student's picture differs from the listing's.
struct WrongPixels {
  std::size_t count = 0;  ///< pixels that are not the same to the bit; NaN equals NaN
  Vec2i first{-1, -1};    ///< the first of them in rows from the top, each from left to right; (-1, -1) = none
  Vec3d own{0, 0, 0}, right{0, 0, 0};  ///< its colour in both
};

/// Compares pictures of one size. Throws InputError if their sizes differ.
WrongPixels wrong_pixels(const Image<Vec3d>& own, const Image<Vec3d>& right);

}  // namespace ps
