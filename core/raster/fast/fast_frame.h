#pragma once
#include "raster/fast/packed_textures.h"

namespace ps::raster {

/// A whole picture at once (Machinery::whole_frame), with the clear path's bits and counts: vertices and triangles in
/// vectors, visibility first, and then each visible fragment shaded once. Fills `frame`, whose colours, depths and ids
/// may be unfilled, its counters and its times.
void draw_fast_frame(const RasterInputs<float>& inputs, const PackedTextures& textures, const RenderRequest& request,
                     Frame& frame, Progress& progress);

}  // namespace ps::raster
