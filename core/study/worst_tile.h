#pragma once
#include "image/image.h"

namespace ps {

/// How visible the worst local difference is: the largest mean FLIP of any tile, the picture being cut evenly into
/// tiles of at least 16 x 16 pixels. The mean over a whole picture hides a missing object; this does not, and is never
/// below it.
double worst_tile_flip(const Image<Rgb8>& reference, const Image<Rgb8>& test);

}  // namespace ps
