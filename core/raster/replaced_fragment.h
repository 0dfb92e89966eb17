#pragma once
#include "raster/clear/geometry.h"
#include "raster/pixel_replay.h"

namespace ps::raster {

/// The colour of the triangle at the pixel, which it need not cover, with the given values in place of its own. What is
/// interpolated is moved to the given value by the same amount in the whole triangle, so that it changes from pixel to
/// pixel as before.
Vec3f shade_replaced(const Pass<float>& pass, const ScreenGeometry<float>& geometry, const TriangleSetup<float>& setup,
                     Vec2i pixel, const GivenFragment& given);

/// What the whole triangle has where the line of sight through the pixel meets its plane, in double and without edges
/// that clipping made: z, and of position, normal, uv and vertex light what the surface interpolates.
GivenFragment whole_triangle_values(const Pass<float>& pass, const ScreenGeometry<float>& geometry,
                                    const TriangleSetup<float>& setup, Vec2i pixel);

}  // namespace ps::raster
