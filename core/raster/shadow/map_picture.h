#pragma once
#include "image/image.h"
#include "raster/shadow/shadow_map.h"

namespace ps::raster {

/// Lays all maps out over a picture, from left to right: a cube unfolded as a cross, a directional light's map as a
/// square. What belongs to no map stays as it is.
void lay_out_maps(const ShadowMaps& maps, Image<float>& picture);

/// Where the faces of an unfolded cube lie on a grid of 4 x 3 squares, in the order of cube_faces(): column and row.
Vec2i cross_cell(int face);

/// Calls texel(x, y, u, v) for each pixel (x, y) of a square at (left, top) of `side` pixels, where u and v from 0 to 1
/// say where in the square it lies.
template <class Texel>
void each_pixel(int left, int top, int side, int width, int height, Texel&& texel) {
  for (int y = std::max(top, 0); y < std::min(top + side, height); ++y)
    for (int x = std::max(left, 0); x < std::min(left + side, width); ++x)
      texel(x, y, (x - left + 0.5) / side, (y - top + 0.5) / side);
}

}  // namespace ps::raster
