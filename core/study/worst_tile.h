#pragma once
#include <vector>

#include "image/image.h"

namespace ps {

/// Mean FLIP of each tile, row by row, the picture being cut evenly into tiles of at least 16 x 16 pixels.
std::vector<double> tile_flips(const Image<Rgb8>& reference, const Image<Rgb8>& test);

/// The largest of tile_flips(): how visible the worst local difference is. The mean over a whole picture hides a
/// missing object; this does not, and is never below it.
double worst_tile_flip(const Image<Rgb8>& reference, const Image<Rgb8>& test);

/// How much the error of one tile grows from one picture to another of the same view, where it grows most; 0 where it
/// grows nowhere. The worst tile alone would hide it, if another one was bad before.
double worst_increase(const std::vector<double>& before, const std::vector<double>& after);

}  // namespace ps
