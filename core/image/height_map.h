#pragma once
#include "image/image.h"
#include "math/vec.h"

namespace ps {

/// Bump maps hold heights in grey (Blinn 1978; map_Bump of .mtl files), normal maps directions in colour; exporters use
/// one statement for both. A picture without any colour is taken for heights.
bool is_height_map(const Image<Vec3f>& image);

/// The normal map of a height map: the surface falls towards -(dh/du, dh/dv), by central differences across the border.
/// `steepness` is how many texels' widths white lies above black.
Image<Vec3f> normals_from_heights(const Image<Vec3f>& heights, double steepness);

}  // namespace ps
