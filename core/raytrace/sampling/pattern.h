#pragma once
#include "math/vec.h"
#include "options/settings.h"

namespace ps {

/// Where the samples of a pixel lie (CGFS ch. 5 asks for more of them, not where).
///
/// grid    n cells of equal area, a sample at the centre of each. A square number gives sqrt(n) x sqrt(n); otherwise
/// rows
///         of nearly equal numbers, each as high as its share of the samples.
/// jitter  the same cells, the sample anywhere in its cell (Cook 1986): noise in the place of regular patterns.
/// random  anywhere in the pixel, each for itself.
/// halton  radical inverses of the index in bases 2 and 3 (Halton 1960), shifted by an amount of the pixel's own.
/// r2      multiples of 1/g and 1/g^2, g the plastic number (Roberts 2018), shifted likewise.
///
/// The numbers depend on the pixel and the index alone, so pictures do not depend on threads or tiles.

/// Position of sample `index` of `count` in the unit square, each coordinate in [0, 1). `pixel` is an array position.
Vec2d sample_in_square(SamplePattern pattern, int index, int count, Vec2i pixel);

/// The same as an offset from the pixel's top-left corner (math/conventions.h): the square is centred on `middle`, the
/// position of a pixel's only sample.
Vec2d sample_in_pixel(SamplePattern pattern, int index, int count, Vec2i pixel, const Vec2d& middle);

}  // namespace ps
